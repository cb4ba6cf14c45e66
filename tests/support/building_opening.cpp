#include "support/building_opening.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

/** Leaves at most this much between them and their frame. */
constexpr double kSlit_m = 0.003;

/** Wall axes from those of a leaf: u from its hinge jamb into the opening, v out of the face that it belongs to. */
struct LeafAxes
{
	double jamb_x;
	double u_sign, v_sign;
	[[nodiscard]] Vector2d at(const Vector2d& leaf) const { return {jamb_x + u_sign * leaf.x(), v_sign * leaf.y()}; }
};

LeafAxes axesOf(const Opening& opening, bool at_start)
{
	const double half = 0.5 * opening.width_m;
	return {opening.middle_m + (at_start ? -half : half), at_start ? 1.0 : -1.0, static_cast<double>(opening.side)};
}

Footprint rectangle(const LeafAxes& axes, const Vector2d& low, const Vector2d& high)
{
	return {axes.at(low), axes.at({high.x(), low.y()}), axes.at(high), axes.at({low.x(), high.y()})};
}

/** A leaf of that length, turned about its hinge at (0, v). */
Footprint hinged(const LeafAxes& axes, double length_m, double v, double angle_rad)
{
	const double c = std::cos(angle_rad), s = std::sin(angle_rad);
	const auto turned = [&](double u, double w) { return axes.at({c * u - s * w, v + s * u + c * w}); };
	return {turned(kSlit_m, -kLeaf_m), turned(length_m, -kLeaf_m), turned(length_m, 0), turned(kSlit_m, 0)};
}

Footprint slid(const Opening& opening, double thickness_m)
{
	const LeafAxes axes = axesOf(opening, opening.hinge_left);
	const double covered = opening.width_m - opening.slid_m;
	if (opening.filling == Filling::sliding_wall)
		return rectangle(axes, {-0.05, -0.5 * kLeaf_m}, {covered, 0.5 * kLeaf_m});
	const double v = 0.5 * thickness_m + 0.015 + opening.casing_proud_m;
	return rectangle(axes, {covered - opening.width_m - 0.1, v}, {covered, v + kLeaf_m});
}

double segmentDistance(const Vector2d& point, const Vector2d& from, const Vector2d& to)
{
	const Vector2d along = to - from;
	const double share = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
	return (point - from - share * along).norm();
}

bool separated(const Footprint& a, const Footprint& b)
{
	for (const Footprint* footprint : {&a, &b})
		for (std::size_t i = 0; i < 4; ++i)
		{
			const Vector2d edge = (*footprint)[(i + 1) % 4] - (*footprint)[i], normal(-edge.y(), edge.x());
			std::array<double, 2> low{1e9, 1e9}, high{-1e9, -1e9};
			std::size_t which = 0;
			for (const Footprint* other : {&a, &b})
			{
				for (const Vector2d& corner : *other)
				{
					low.at(which) = std::min(low.at(which), normal.dot(corner));
					high.at(which) = std::max(high.at(which), normal.dot(corner));
				}
				++which;
			}
			if (high[0] < low[1] || high[1] < low[0]) return true;
		}
	return false;
}

/** What stands at one jamb: wall, stop, casings and the leaf that is hinged (or slides) there. */
std::vector<Footprint> solidsAt(const Opening& opening, double thickness_m, bool at_start)
{
	const LeafAxes axes = axesOf(opening, at_start);
	const double half = 0.5 * thickness_m;
	std::vector<Footprint> solids{rectangle(axes, {-1, -half}, {0, half})};
	if (opening.stop_m > 0)
	{
		const double v = half - opening.recess_m - kLeaf_m;
		solids.push_back(rectangle(axes, {-0.1, v - 0.03}, {opening.stop_m, v}));
	}
	if (opening.casing_m > 0 && opening.casing_at[at_start ? 0 : 1])
		for (const double face : {-1.0, 1.0})
			solids.push_back(
			    rectangle(axes, {-opening.casing_m, face * half}, {-0.005, face * (half + opening.casing_proud_m)}));
	// A wall across, as far as a leaf reaches.
	const double across = opening.corner_m[at_start ? 0 : 1];
	if (across < 1) solids.push_back(rectangle(axes, {-across - 0.1, 0}, {-across, half + 1.5}));
	const std::vector<Footprint> leaves = leavesOf(opening, thickness_m);
	if (opening.filling == Filling::two_leaves)
		solids.push_back(leaves[at_start ? 0 : 1]);
	else if (!leaves.empty() && at_start == opening.hinge_left)
		solids.push_back(leaves[0]);
	return solids;
}

void buildFootprint(Sketch& sketch, const std::string& name, Look look, const Place& wall, const Footprint& footprint,
                    double low_m, double high_m)
{
	const Vector2d along = footprint[1] - footprint[0], across = footprint[3] - footprint[0];
	const Vector2d middle = 0.5 * (footprint[0] + footprint[2]);
	sketch.box(name, look, wall, {middle.x(), middle.y(), 0.5 * (low_m + high_m)},
	           {along.norm(), across.norm(), high_m - low_m}, std::atan2(along.y(), along.x()));
}

/** Lever and rose on both faces. */
void buildHandle(Sketch& sketch, const std::string& name, const Place& wall, const Footprint& leaf)
{
	const Vector2d along = (leaf[1] - leaf[0]).normalized(), across = (leaf[3] - leaf[0]).normalized();
	const double yaw = std::atan2(along.y(), along.x());
	for (const double face : {-1.0, 1.0})
	{
		const Vector2d root = 0.5 * (leaf[1] + leaf[2]) - 0.06 * along + face * (0.5 * kLeaf_m + 0.025) * across;
		sketch.box(name, Look::metal, wall, {root.x(), root.y(), 1.05}, {0.02, 0.05, 0.02}, yaw);
		const Vector2d lever = root - 0.05 * along + face * 0.02 * across;
		sketch.box(name, Look::metal, wall, {lever.x(), lever.y(), 1.05}, {0.12, 0.015, 0.02}, yaw);
	}
}

void buildLeaf(Sketch& sketch, const std::string& name, const Place& wall, const Footprint& leaf,
               const Opening& opening)
{
	const double low = opening.low_m + 0.008, high = opening.high_m - kSlit_m;
	if (opening.leaf_look != Look::glass)
	{
		buildFootprint(sketch, name, opening.leaf_look, wall, leaf, low, high);
		buildHandle(sketch, name, wall, leaf);
		return;
	}
	// A frame of 9 cm around the pane.
	const auto part = [&](double from, double to, double inset)
	{
		const auto mix = [&](const Vector2d& a, const Vector2d& b, double share) -> Vector2d
		{ return a + share * (b - a); };
		const Vector2d thin = inset * (leaf[3] - leaf[0]);
		return Footprint{mix(leaf[0], leaf[1], from) + thin, mix(leaf[0], leaf[1], to) + thin,
		                 mix(leaf[3], leaf[2], to) - thin, mix(leaf[3], leaf[2], from) - thin};
	};
	const double rim = 0.09 / (leaf[1] - leaf[0]).norm();
	buildFootprint(sketch, name, Look::wood, wall, part(0, rim, 0), low, high);
	buildFootprint(sketch, name, Look::wood, wall, part(1 - rim, 1, 0), low, high);
	buildFootprint(sketch, name, Look::wood, wall, part(rim, 1 - rim, 0), low, low + 0.12);
	buildFootprint(sketch, name, Look::wood, wall, part(rim, 1 - rim, 0), high - 0.09, high);
	buildFootprint(sketch, name, Look::glass, wall, part(rim, 1 - rim, 0.4), low + 0.12, high - 0.09);
	buildHandle(sketch, name, wall, leaf);
}

void buildCasing(Sketch& sketch, const WallFrame& wall, const Opening& opening)
{
	const double half = 0.5 * opening.width_m, face = 0.5 * wall.thickness_m, top = opening.high_m;
	if (opening.casing_m <= 0) return;
	for (const double side : {-1.0, 1.0})
	{
		const double a = side * face, b = side * (face + opening.casing_proud_m);
		const double low_y = std::min(a, b), high_y = std::max(a, b);
		double from = opening.middle_m - half - 0.005, to = opening.middle_m + half + 0.005;
		if (opening.casing_at[0])
			sketch.block("casing", Look::white, wall.start, {from - opening.casing_m + 0.005, low_y, 0},
			             {from, high_y, top + 0.005});
		if (opening.casing_at[1])
			sketch.block("casing", Look::white, wall.start, {to, low_y, 0},
			             {to + opening.casing_m - 0.005, high_y, top + 0.005});
		from -= opening.casing_at[0] ? opening.casing_m - 0.005 : 0;
		to += opening.casing_at[1] ? opening.casing_m - 0.005 : 0;
		if (opening.arch_m <= 0 && top < wall.height_m - 0.15)
			sketch.block("casing", Look::white, wall.start, {from, low_y, top + 0.005},
			             {to, high_y, top + opening.casing_m});
	}
}

void buildStops(Sketch& sketch, const WallFrame& wall, const Opening& opening)
{
	if (opening.stop_m <= 0) return;
	for (const bool at_start : {true, false})
	{
		const LeafAxes axes = axesOf(opening, at_start);
		const double v = 0.5 * wall.thickness_m - opening.recess_m - kLeaf_m;
		buildFootprint(sketch, "stop", Look::white, wall.start, rectangle(axes, {0, v - 0.03}, {opening.stop_m, v}),
		               opening.low_m, opening.high_m);
	}
}

/** The wall above: flat, or an arch of narrow pieces. */
void buildHead(Sketch& sketch, const WallFrame& wall, const Opening& opening)
{
	constexpr int kPieces = 24;
	const double half = 0.5 * opening.width_m, face = 0.5 * wall.thickness_m;
	const int pieces = opening.arch_m > 0 ? kPieces : 1;
	for (int i = 0; i < pieces; ++i)
	{
		const double from = -half + opening.width_m * i / pieces, to = from + opening.width_m / pieces;
		const double off = 0.5 * (from + to) / half;
		const double low = opening.high_m - opening.arch_m * (pieces == 1 ? 0 : 1 - std::sqrt(1 - off * off));
		sketch.block("head", Look::wall, wall.start, {opening.middle_m + from, -face, low},
		             {opening.middle_m + to, face, wall.height_m});
	}
}

void buildWindow(Sketch& sketch, const WallFrame& wall, const Opening& opening, Dice& dice)
{
	constexpr double kFrame_m = 0.06;
	const double from = opening.middle_m - 0.5 * opening.width_m, to = from + opening.width_m;
	const double low = opening.low_m, high = opening.high_m, y = 0.5 * kFrame_m;
	const auto bar = [&](double x0, double x1, double z0, double z1) {
		sketch.block("window", Look::white, wall.start, {x0, -y, z0}, {x1, y, z1});
	};
	bar(from, to, low, low + kFrame_m);
	bar(from, to, high - kFrame_m, high);
	const int panes = std::max(1, static_cast<int>(std::lround(opening.width_m / dice.between(0.6, 1.3))));
	for (int i = 0; i <= panes; ++i)
	{
		const double x = from + (opening.width_m - kFrame_m) * i / panes;
		bar(x, x + kFrame_m, low + kFrame_m, high - kFrame_m);
	}
	sketch.block("pane", Look::glass, wall.start, {from + 0.02, -0.006, low + 0.02}, {to - 0.02, 0.006, high - 0.02});
	if (low > 0.2 && dice.chance(0.6))
		sketch.block("board", Look::white, wall.start, {from - 0.05, -0.5 * wall.thickness_m - 0.1, low - 0.03},
		             {to + 0.05, 0, low});
}

void buildCurtain(Sketch& sketch, const WallFrame& wall, const Opening& opening)
{
	constexpr double kFold_m = 0.07;
	const int folds = static_cast<int>((opening.width_m + 0.2) / kFold_m);
	for (int i = 0; i < folds; ++i)
	{
		const double x = opening.middle_m + (i + 0.5 - 0.5 * folds) * kFold_m;
		const double y = opening.side * (0.5 * wall.thickness_m + opening.casing_proud_m + 0.04 + (i % 2) * 0.03);
		sketch.box("curtain", Look::fabric, wall.start, {x, y, 0.5 * (opening.high_m + 0.12)},
		           {kFold_m + 0.03, 0.012, opening.high_m + 0.06}, (i % 2 == 0 ? 0.5 : -0.5));
	}
}

/** Cartons or a cupboard in the doorway; what they leave is at the wall's end. */
void buildBoxes(Sketch& sketch, const WallFrame& wall, const Opening& opening, Dice& dice)
{
	const double from = opening.middle_m - 0.5 * opening.width_m, width = opening.width_m - opening.slid_m;
	double z = opening.low_m;
	// So high that a MAV does not fit above it either.
	for (const double top = std::min(1.75, opening.high_m - 0.1); z < top;)
	{
		const double height = dice.between(0.3, 0.6), depth = dice.between(0.35, 0.6);
		sketch.block("carton", Look::cardboard, wall.start, {from, -0.5 * depth, z},
		             {from + width - (z > opening.low_m ? dice.between(0, 0.06) : 0), 0.5 * depth, z + height});
		z += height;
	}
}

std::string verdictOf(const Opening& opening, double clear_m)
{
	constexpr double kOpen_rad = 80 * std::numbers::pi / 180;
	switch (opening.filling)
	{
		case Filling::curtain:
		case Filling::person:
		case Filling::boxes:
		case Filling::counter:
			return "blocked";
		case Filling::leaf:
		case Filling::two_leaves:
			if (opening.angle_rad == 0) return "closed";
			if (opening.angle_rad < kOpen_rad && !opening.drop) return "ajar";
			break;
		case Filling::sliding_face:
		case Filling::sliding_wall:
			if (opening.slid_m == 0) return "closed";
			if (clear_m < opening.width_m - 0.1) return "ajar";
			break;
		default:
			break;
	}
	if (opening.drop) return "drop";
	return opening.passage ? "passage" : "open";
}

/** What people or boxes leave, or a leaf. */
double labelledClear(const Opening& opening, double thickness_m)
{
	if (opening.filling == Filling::curtain) return 0;
	if (opening.filling == Filling::boxes) return opening.slid_m;
	if (opening.filling == Filling::person) return std::max(0.0, 0.5 * opening.width_m - 0.25);
	if (opening.filling == Filling::counter) return opening.width_m;
	if (opening.filling == Filling::leaf || opening.filling == Filling::two_leaves)
		if (opening.angle_rad == 0) return 0;
	if (opening.filling == Filling::sliding_face || opening.filling == Filling::sliding_wall)
		if (opening.slid_m == 0) return 0;
	return clearWidthOf(opening, thickness_m);
}

void label(Sketch& sketch, const WallFrame& wall, const Opening& opening)
{
	PlannedDoor door;
	door.id = opening.id;
	door.place = wall.start.then({opening.middle_m, 0});
	door.width_m = opening.width_m;
	if (opening.high_m < wall.height_m - 0.01) door.height_m = opening.high_m;
	door.depth_m = wall.thickness_m;
	door.clear_width_m = labelledClear(opening, wall.thickness_m);
	door.verdict = verdictOf(opening, door.clear_width_m);
	door.sill_m = opening.low_m;
	sketch.doors.push_back(std::move(door));
}

void buildBoltedLeaf(Sketch& sketch, const WallFrame& wall, const Opening& whole)
{
	const LeafAxes axes = axesOf(whole, !whole.hinge_left);
	const double v = 0.5 * wall.thickness_m - whole.recess_m;
	buildFootprint(sketch, "bolted", whole.leaf_look == Look::glass ? Look::wood : whole.leaf_look, wall.start,
	               rectangle(axes, {0, v - kLeaf_m}, {0.5 * whole.width_m, v}), whole.low_m, whole.high_m);
}

void buildFilling(Sketch& sketch, const WallFrame& wall, const Opening& opening, Dice& dice)
{
	const std::string leaf_name = opening.id + "_leaf";
	for (const Footprint& leaf : leavesOf(opening, wall.thickness_m))
		buildLeaf(sketch, leaf_name, wall.start, leaf, opening);
	if (opening.filling == Filling::sliding_face)
		sketch.box("rail", Look::metal, wall.start,
		           {opening.middle_m + (opening.hinge_left ? -0.5 : 0.5) * opening.width_m,
		            opening.side * (0.5 * wall.thickness_m + opening.casing_proud_m + 0.02), opening.high_m + 0.1},
		           {2 * opening.width_m, 0.03, 0.05});
	if (opening.filling == Filling::curtain) buildCurtain(sketch, wall, opening);
	if (opening.filling == Filling::boxes) buildBoxes(sketch, wall, opening, dice);
	if (opening.filling == Filling::person)
		buildPerson(sketch, wall.start.then({opening.middle_m, 0}, dice.between(0, 6)), "person", dice);
	if (opening.filling == Filling::counter)
		sketch.block("counter", Look::wood, wall.start,
		             {opening.middle_m - 0.5 * opening.width_m, -0.5 * wall.thickness_m - 0.1, opening.low_m - 0.04},
		             {opening.middle_m + 0.5 * opening.width_m, 0.5 * wall.thickness_m + 0.1, opening.low_m});
}
}  // namespace

double distanceOf(const Footprint& a, const Footprint& b)
{
	if (!separated(a, b)) return 0;
	double nearest = 1e9;
	for (std::size_t i = 0; i < 4; ++i)
		for (std::size_t k = 0; k < 4; ++k)
			nearest = std::min(
			    {nearest, segmentDistance(a[i], b[k], b[(k + 1) % 4]), segmentDistance(b[i], a[k], a[(k + 1) % 4])});
	return nearest;
}

Opening movingPartOf(const Opening& opening)
{
	Opening part = opening;
	if (opening.filling != Filling::fixed_leaf) return part;
	part.filling = Filling::leaf;
	part.width_m = 0.5 * opening.width_m;
	part.middle_m += opening.hinge_left ? -0.5 * part.width_m : 0.5 * part.width_m;
	part.stop_m = 0;
	part.corner_m[opening.hinge_left ? 1 : 0] = 10;
	part.casing_at[opening.hinge_left ? 1 : 0] = false;
	return part;
}

std::vector<Footprint> leavesOf(const Opening& opening, double thickness_m)
{
	const double v = 0.5 * thickness_m - opening.recess_m, width = opening.width_m;
	switch (opening.filling)
	{
		case Filling::leaf:
			return {hinged(axesOf(opening, opening.hinge_left), width - kSlit_m, v, opening.angle_rad)};
		case Filling::two_leaves:
			return {hinged(axesOf(opening, true), 0.5 * width - kSlit_m, v, opening.angle_rad),
			        hinged(axesOf(opening, false), 0.5 * width - kSlit_m, v, opening.angle_rad)};
		case Filling::sliding_face:
		case Filling::sliding_wall:
			return {slid(opening, thickness_m)};
		default:
			return {};
	}
}

double clearWidthOf(const Opening& opening, double thickness_m)
{
	double clear = opening.width_m;
	for (const Footprint& a : solidsAt(opening, thickness_m, true))
		for (const Footprint& b : solidsAt(opening, thickness_m, false)) clear = std::min(clear, distanceOf(a, b));
	return clear;
}

void buildOpening(Sketch& sketch, const WallFrame& wall, const Opening& opening, Dice& dice)
{
	const double from = opening.middle_m - 0.5 * opening.width_m, to = from + opening.width_m;
	const double face = 0.5 * wall.thickness_m;
	sketch.block("sill", opening.filling == Filling::window ? Look::wall : Look::wood, wall.start, {from, -face, 0},
	             {to, face, opening.low_m});
	buildHead(sketch, wall, opening);
	if (opening.filling == Filling::window) return buildWindow(sketch, wall, opening, dice);
	if (opening.filling == Filling::niche)
	{
		const double back = opening.side * (face - opening.depth_m);
		sketch.block("back", Look::wall, wall.start, {from, opening.side > 0 ? -face : back, opening.low_m},
		             {to, opening.side > 0 ? back : face, opening.high_m});
		return;
	}
	buildCasing(sketch, wall, opening);
	buildStops(sketch, wall, opening);
	const Opening used = movingPartOf(opening);
	if (opening.filling == Filling::fixed_leaf) buildBoltedLeaf(sketch, wall, opening);
	buildFilling(sketch, wall, used, dice);
	label(sketch, wall, used);
}

void buildPerson(Sketch& sketch, const Place& place, const std::string& name, Dice& dice)
{
	const double height = dice.between(1.65, 1.9), wide = dice.between(0.9, 1.1);
	for (const double side : {-1.0, 1.0})
	{
		sketch.cylinder(name, Look::fabric, place, {0, side * 0.10 * wide, 0.25 * height}, 0.07 * wide, 0.46 * height);
		sketch.box(name, Look::metal, place, {0.05, side * 0.10 * wide, 0.04}, {0.26, 0.09, 0.08});
		sketch.capsule(name, Look::fabric, place, {0, side * 0.21 * wide, 0.63 * height}, 0.045, 0.30 * height);
	}
	sketch.capsule(name, Look::fabric, place, {0, 0, 0.64 * height}, 0.15 * wide, 0.20 * height);
	sketch.box(name, Look::fabric, place, {0, 0, 0.76 * height}, {0.18, 0.40 * wide, 0.12 * height});
	sketch.cylinder(name, Look::skin, place, {0, 0, 0.85 * height}, 0.05, 0.06 * height);
	sketch.sphere(name, Look::skin, place, {0, 0, 0.93 * height}, 0.07 * height / 1.0);
	sketch.obstacles.push_back({"person", place.origin, 0.25, height});
}
}  // namespace explore::test
