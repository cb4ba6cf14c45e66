#include "scene_walls.h"

#include <explore/simulation/shapes.h>

#include <algorithm>

namespace explore::simulation
{
namespace
{
const Eigen::Vector3f kPlaster(0.82F, 0.8F, 0.74F), kWood(0.55F, 0.4F, 0.26F), kStone(0.5F, 0.48F, 0.45F);

/** Strips along both faces between the openings that reach the floor. */
void addSkirting(Sketch& sketch, const WallPlan& wall)
{
	const double depth_m = sketch.style.skirting_depth_m, height_m = sketch.style.skirting_height_m;
	if (!wall.skirted || depth_m <= 0) return;
	const std::size_t wood = sketch.material("skirting", kWood);
	const double casing_m = sketch.style.casing_width_m;
	double from_m = wall.along.low;
	const auto strip = [&](double to_m)
	{
		for (const Span& behind : {Span{-depth_m, 0.0}, Span{wall.thickness_m, wall.thickness_m + depth_m}})
			sketch.block("skirting", wall.frame, {from_m, to_m}, behind, {0, height_m}, wood);
	};
	for (const Opening& opening : wall.openings)
	{
		if (opening.z.low > height_m) continue;
		const double casing = opening.cased ? casing_m : 0.0;
		strip(opening.along.low - casing);
		from_m = opening.along.high + casing;
	}
	strip(wall.along.high);
}

/** Moulding on both faces around an opening. */
void addCasing(Sketch& sketch, const WallPlan& wall, const Opening& opening)
{
	const double depth_m = sketch.style.casing_depth_m, width_m = sketch.style.casing_width_m;
	if (!opening.cased || depth_m <= 0) return;
	const std::size_t wood = sketch.material("casing", kWood);
	const bool lintel = opening.z.high + width_m < wall.height_m;
	const double top_m = lintel ? opening.z.high + width_m : wall.height_m;
	const Span low{opening.along.low - width_m, opening.along.low},
	    high{opening.along.high, opening.along.high + width_m};
	for (const Span& behind : {Span{-depth_m, 0.0}, Span{wall.thickness_m, wall.thickness_m + depth_m}})
	{
		for (const Span& side : {low, high})
			sketch.block("casing", wall.frame, side, behind, {opening.z.low, top_m}, wood);
		if (lintel) sketch.block("casing", wall.frame, opening.along, behind, {opening.z.high, top_m}, wood);
	}
}
}  // namespace

WallPlan plainWall(Sketch& sketch, const WallFrame& frame, const Span& along)
{
	WallPlan wall;
	wall.frame = frame;
	wall.along = along;
	wall.thickness_m = sketch.style.wall_thickness_m;
	wall.height_m = sketch.style.wall_height_m;
	return wall;
}

void buildWall(Sketch& sketch, WallPlan wall)
{
	std::sort(wall.openings.begin(), wall.openings.end(),
	          [](const Opening& a, const Opening& b) { return a.along.low < b.along.low; });
	const std::size_t plaster = sketch.material(wall.material, kPlaster);
	const Span through{0, wall.thickness_m};
	const auto piece = [&](const Span& along, const Span& z)
	{ sketch.block(wall.body, wall.frame, along, through, z, plaster); };
	double from_m = wall.along.low;
	for (const Opening& opening : wall.openings)
	{
		piece({from_m, opening.along.low}, {0, wall.height_m});
		piece(opening.along, {0, opening.z.low});
		piece(opening.along, {opening.z.high, wall.height_m});
		addCasing(sketch, wall, opening);
		from_m = opening.along.high;
	}
	piece({from_m, wall.along.high}, {0, wall.height_m});
	addSkirting(sketch, wall);
}

WallFrame faceOf(const Space& space, Side side)
{
	constexpr double kRight_rad = std::numbers::pi / 2;
	const WallFrame& frame = space.frame;
	switch (side)
	{
		case Side::near:
			return {frame.at(space.along.high, space.behind.low), frame.angle_rad + 2 * kRight_rad};
		case Side::left:
			return {frame.at(space.along.low, space.behind.low), frame.angle_rad + kRight_rad};
		case Side::right:
			return {frame.at(space.along.high, space.behind.high), frame.angle_rad - kRight_rad};
		default:
			return {frame.at(space.along.low, space.behind.high), frame.angle_rad};
	}
}

double lengthOf(const Space& space, Side side)
{
	return side == Side::left || side == Side::right ? space.behind.length() : space.along.length();
}

void enclose(Sketch& sketch, const Space& space, std::initializer_list<Side> sides, const std::string& material)
{
	for (const Side side : sides)
	{
		// Far enough to close the corners, but not to the other face of a wall that is met.
		const double corner_m = sketch.style.wall_thickness_m - 0.002;
		WallPlan wall = plainWall(sketch, faceOf(space, side), Span{0, lengthOf(space, side)}.grown(corner_m));
		wall.material = material;
		wall.skirted = material == "plaster";
		buildWall(sketch, wall);
	}
}

void layFloorAndCeiling(Sketch& sketch)
{
	Eigen::AlignedBox2d box;
	for (const Eigen::Vector3f& vertex : sketch.world.mesh.vertices) box.extend(vertex.head<2>().cast<double>());
	const auto edge = [&sketch] { return sketch.random.uniform(0.2, 2.0); };
	const Span all_x{box.min().x() - edge(), box.max().x() + edge()};
	const Span all_y{box.min().y() - edge(), box.max().y() + edge()};
	const std::size_t stone = sketch.material("floor", kStone);
	const WallFrame building;
	const auto slab = [&](const char* name, const Span& x, const Span& y, const Span& z, std::size_t material)
	{ sketch.block(name, building, x, y, z, material); };

	// Strips in y beside the holes, one after another in x.
	constexpr double kThickness_m = 0.1;
	const Span ground{-kThickness_m, 0};
	double from_m = all_x.low;
	std::sort(sketch.floor_holes.begin(), sketch.floor_holes.end(),
	          [](const Outline& a, const Outline& b) { return a[0].x() < b[0].x(); });
	for (const Outline& hole : sketch.floor_holes)
	{
		const Span x{hole[0].x(), hole[2].x()}, y{hole[0].y(), hole[2].y()};
		slab("floor", {from_m, x.low}, all_y, ground, stone);
		slab("floor", x, {all_y.low, y.low}, ground, stone);
		slab("floor", x, {y.high, all_y.high}, ground, stone);
		from_m = x.high;
	}
	slab("floor", {from_m, all_x.high}, all_y, ground, stone);
	const double top_m = sketch.style.wall_height_m;
	if (sketch.style.ceiling)
		slab("ceiling", all_x, all_y, {top_m, top_m + kThickness_m}, sketch.material("ceiling", kPlaster));
}

void labelCorridor(Sketch& sketch, const Space& space)
{
	constexpr double kWidest_m = 4.0, kShortest = 1.3;
	const bool runs_along = space.along.length() >= space.behind.length();
	const double width_m = runs_along ? space.behind.length() : space.along.length();
	const double length_m = runs_along ? space.along.length() : space.behind.length();
	if (width_m > kWidest_m || length_m < kShortest * width_m) return;
	CorridorLabel label;
	label.id = "corridor_" + std::to_string(sketch.world.corridors.size() + 1);
	const double middle_along_m = space.along.middle(), middle_behind_m = space.behind.middle();
	label.start_in_map = runs_along ? space.frame.at(space.along.low, middle_behind_m)
	                                : space.frame.at(middle_along_m, space.behind.low);
	label.end_in_map = runs_along ? space.frame.at(space.along.high, middle_behind_m)
	                              : space.frame.at(middle_along_m, space.behind.high);
	label.width_m = width_m;
	sketch.world.corridors.push_back(label);
}
}  // namespace explore::simulation
