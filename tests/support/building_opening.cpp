#include "support/building_opening.h"

#include "support/building_labels.h"
#include "support/building_leaves.h"
#include "support/building_pieces.h"

#include <algorithm>
#include <cmath>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;

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
	labelDoor(sketch, wall, used);
}

}  // namespace explore::test
