// Walls, floors, ceilings and stairs of a made-up building as shapes.
#include "support/building_plan.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSlab_m = 0.2, kShaft_m = 3.2;
const Place kPlan;

void slab(Sketch& sketch, const char* name, Look look, const Area& area, double low, double high)
{
	sketch.block(name, look, kPlan, {area.min().x(), area.min().y(), low}, {area.max().x(), area.max().y(), high});
}

struct Skirting
{
	double proud_m = 0, height_m = 0;
};

void buildSkirting(Sketch& sketch, const BuildingWall& wall, const std::vector<Opening>& openings,
                   const Skirting& skirting)
{
	for (const int side : {1, -1})
	{
		if (wall.roomAt(side) < 0) continue;
		const double face = side * 0.5 * wall.frame.thickness_m, far = face + side * skirting.proud_m;
		double from = wall.from_m;
		const auto board = [&](double to)
		{
			sketch.block("skirting", Look::white, wall.frame.start, {from, std::min(face, far), 0},
			             {to, std::max(face, far), skirting.height_m});
		};
		for (const Opening& opening : openings)
		{
			if (opening.low_m > skirting.height_m) continue;
			const double half = 0.5 * opening.width_m + opening.casing_m;
			board(opening.middle_m - half);
			from = std::max(from, opening.middle_m + half);
		}
		board(wall.to_m);
	}
}

void buildWall(Sketch& sketch, const BuildingWall& wall, const Skirting& skirting, Dice& dice)
{
	std::vector<Opening> openings = wall.openings;
	std::sort(openings.begin(), openings.end(),
	          [](const Opening& a, const Opening& b) { return a.middle_m < b.middle_m; });
	const double face = 0.5 * wall.frame.thickness_m;
	double from = 0;
	for (const Opening& opening : openings)
	{
		sketch.block("wall", Look::wall, wall.frame.start, {from, -face, 0},
		             {opening.middle_m - 0.5 * opening.width_m, face, wall.frame.height_m});
		from = opening.middle_m + 0.5 * opening.width_m;
		buildOpening(sketch, wall.frame, opening, dice);
	}
	sketch.block("wall", Look::wall, wall.frame.start, {from, -face, 0}, {wall.length_m, face, wall.frame.height_m});
	if (skirting.proud_m > 0) buildSkirting(sketch, wall, openings, skirting);
}

/** Fills the corners where walls of different directions meet. */
void buildPosts(Sketch& sketch, const Plan& plan)
{
	std::map<std::pair<double, double>, Vector2d> sizes;
	for (const BuildingWall& wall : plan.walls)
	{
		const bool along_x = wall.frame.start.yaw_rad == 0;
		if (!along_x && std::abs(wall.frame.start.yaw_rad - std::acos(0.0)) > 1e-9) continue;
		for (const double end : {0.0, wall.length_m})
		{
			const Vector2d at = wall.frame.start.at({end, 0});
			Vector2d& size =
			    sizes.try_emplace({std::round(at.x() * 1e6) / 1e6, std::round(at.y() * 1e6) / 1e6}, 0, 0).first->second;
			double& across = along_x ? size.y() : size.x();
			across = std::max(across, wall.frame.thickness_m);
		}
	}
	for (const auto& [at, size] : sizes)
		sketch.block("post", Look::wall, kPlan, {at.first - 0.5 * size.x(), at.second - 0.5 * size.y(), 0},
		             {at.first + 0.5 * size.x(), at.second + 0.5 * size.y(), plan.height_m});
}

/** A coordinate along the flight that begins at the door's side of the room. */
Area acrossFlight(const Room& room, double from, double to)
{
	Area area = room.axes;
	const int axis = room.way_down < 2 ? 0 : 1;
	const bool from_low = room.way_down % 2 == 0;
	const double edge = from_low ? room.inside.min()[axis] : room.inside.max()[axis];
	area.min()[axis] = from_low ? edge + from : edge - to;
	area.max()[axis] = from_low ? edge + to : edge - from;
	return area;
}

void buildStairs(Sketch& sketch, const Plan& plan, const Room& room, Dice& dice)
{
	const double rise = dice.between(0.16, 0.19), tread = dice.between(0.25, 0.30);
	const bool down = room.use == Use::stairs_down;
	const double length = room.inside.sizes()[room.way_down < 2 ? 0 : 1];
	// Floor from the middle of the door's wall to the first step.
	slab(sketch, "landing", Look::floor, acrossFlight(room, -0.5 * plan.outer_m, room.landing_m), -kSlab_m, 0);
	if (!down) slab(sketch, "landing", Look::floor, room.axes, -kSlab_m, -0.001);
	const int steps = static_cast<int>((length - room.landing_m) / tread);
	for (int i = 0; i < steps; ++i)
	{
		const double top = (down ? -1 : 1) * rise * (i + 1);
		if (top < -kShaft_m + 0.1) break;
		slab(sketch, "step", Look::floor,
		     acrossFlight(room, room.landing_m + i * tread, room.landing_m + (i + 1) * tread), down ? -kShaft_m : 0.0,
		     top);
	}
	// The shaft goes on above or below.
	const double low = down ? -kShaft_m : plan.height_m, high = down ? -kSlab_m : plan.height_m + 2.5;
	const Vector2d a = room.axes.min(), b = room.axes.max();
	constexpr double kWall_m = 0.1;
	slab(sketch, "shaft", Look::wall, Area(a - Vector2d(kWall_m, kWall_m), Vector2d(b.x() + kWall_m, a.y())), low,
	     high);
	slab(sketch, "shaft", Look::wall, Area(Vector2d(a.x() - kWall_m, b.y()), b + Vector2d(kWall_m, kWall_m)), low,
	     high);
	slab(sketch, "shaft", Look::wall, Area(a - Vector2d(kWall_m, 0), Vector2d(a.x(), b.y())), low, high);
	slab(sketch, "shaft", Look::wall, Area(Vector2d(b.x(), a.y()), b + Vector2d(kWall_m, 0)), low, high);
	if (down) slab(sketch, "shaft", Look::floor, room.axes, -kShaft_m - kSlab_m, -kShaft_m);
	slab(sketch, "shaft", Look::ceiling, room.axes, down ? plan.height_m : high,
	     (down ? plan.height_m : high) + kSlab_m);
}

void buildCeiling(Sketch& sketch, const Plan& plan, const Room& room, Dice& dice)
{
	const bool low = plan.height_m > 4 && room.use != Use::warehouse;
	const double height = low ? dice.between(2.5, 3.0) : plan.height_m;
	slab(sketch, "ceiling", Look::ceiling, room.axes, height, height + kSlab_m);
	if (low || room.inside.sizes().minCoeff() < 3.5 || !dice.chance(0.35)) return;
	const bool along_x = room.inside.sizes().x() < room.inside.sizes().y();
	const int axis = along_x ? 1 : 0;
	const double deep = dice.between(0.1, 0.3), spacing = dice.between(1.5, 3.0), wide = dice.between(0.12, 0.3);
	for (double at = room.inside.min()[axis] + 0.5 * spacing; at + wide < room.inside.max()[axis]; at += spacing)
	{
		Area beam = room.axes;
		beam.min()[axis] = at;
		beam.max()[axis] = at + wide;
		slab(sketch, "beam", Look::ceiling, beam, height - deep, height);
	}
}

/** Ground and a fence around the house. */
void buildOutdoors(Sketch& sketch, const Plan& plan)
{
	constexpr double kYard_m = 9.0, kFence_m = 0.2;
	Area all;
	for (const Room& room : plan.rooms) all.extend(room.axes);
	Area outer(all.min() - Vector2d(kYard_m, kYard_m), all.max() + Vector2d(kYard_m, kYard_m));
	const auto ring = [&](const char* name, Look look, const Area& hole, const Area& rim, double low, double high)
	{
		slab(sketch, name, look, Area(rim.min(), Vector2d(rim.max().x(), hole.min().y())), low, high);
		slab(sketch, name, look, Area(Vector2d(rim.min().x(), hole.max().y()), rim.max()), low, high);
		slab(sketch, name, look,
		     Area(Vector2d(rim.min().x(), hole.min().y()), Vector2d(hole.min().x(), hole.max().y())), low, high);
		slab(sketch, name, look,
		     Area(Vector2d(hole.max().x(), hole.min().y()), Vector2d(rim.max().x(), hole.max().y())), low, high);
	};
	ring("yard", Look::floor, all, outer, -kSlab_m, 0);
	// What the plan leaves of its bounding rectangle is yard too; below the rooms' floors.
	ring("fence", Look::leaves, outer,
	     Area(outer.min() - Vector2d(kFence_m, kFence_m), outer.max() + Vector2d(kFence_m, kFence_m)), 0, 2.0);
}
}  // namespace

void buildShell(Sketch& sketch, const Plan& plan, Dice& dice)
{
	Skirting skirting;
	if (dice.chance(0.7)) skirting = {dice.between(0.01, 0.02), dice.between(0.05, 0.12)};
	for (const BuildingWall& wall : plan.walls) buildWall(sketch, wall, skirting, dice);
	buildPosts(sketch, plan);
	for (const Room& room : plan.rooms)
	{
		const bool stairs = room.use == Use::stairs_down || room.use == Use::stairs_up;
		if (stairs && room.landing_m > 0)
			buildStairs(sketch, plan, room, dice);
		else
		{
			slab(sketch, "floor", Look::floor, room.axes, -kSlab_m, 0);
			buildCeiling(sketch, plan, room, dice);
		}
	}
	buildOutdoors(sketch, plan);
}
}  // namespace explore::test
