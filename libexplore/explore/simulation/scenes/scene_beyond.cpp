#include "scene_beyond.h"

#include <explore/simulation/scenes/scene_clutter.h>

#include <algorithm>

namespace explore::simulation
{
namespace
{
const Eigen::Vector3f kSoot(0.08F, 0.08F, 0.08F), kStone(0.5F, 0.48F, 0.45F);

/** Doorways that share what is behind them. */
struct Group
{
	std::vector<DoorPlan*> doors;
	Span reach;  ///< along the wall

	[[nodiscard]] Beyond beyond() const { return doors.front()->beyond; }
	[[nodiscard]] Span hull() const { return {doors.front()->along().low, doors.back()->along().high}; }
};

std::vector<Group> groupsOf(Sketch& sketch, std::vector<DoorPlan>& doors, const Span& limits, double thickness_m)
{
	std::sort(doors.begin(), doors.end(), [](const DoorPlan& a, const DoorPlan& b) { return a.along_m < b.along_m; });
	std::vector<Group> groups;
	for (DoorPlan& door : doors)
	{
		const bool alike = !groups.empty() && groups.back().beyond() == door.beyond;
		const double gap_m = groups.empty() ? 0.0 : door.along().low - groups.back().hull().high;
		if (alike && (gap_m < 2 * thickness_m + 0.1 || sketch.random.chance(0.4)))
		{
			groups.back().doors.push_back(&door);
			continue;
		}
		double from_m = limits.low;
		if (!groups.empty())
		{
			const double middle_m = groups.back().hull().high + 0.5 * gap_m;
			groups.back().reach.high = middle_m - 0.5 * thickness_m;
			from_m = middle_m + 0.5 * thickness_m;
		}
		groups.push_back({{&door}, {from_m, limits.high}});
	}
	return groups;
}

/** A room, a corridor across or one straight on. */
Space drawSpace(Sketch& sketch, const WallPlan& wall, const Group& group)
{
	Random& random = sketch.random;
	const Span hull = group.hull();
	const int kind = random.integer(0, 2);
	Span beside_m{0.1, 3.0}, depth_m{1.8, 6.0};
	if (kind == 1) beside_m = {3.0, 9.0}, depth_m = {1.4, 2.6};
	if (kind == 2 && hull.length() < 1.7) beside_m = {0.05, 0.5}, depth_m = {4.0, 12.0};
	if (group.beyond() == Beyond::dark) beside_m = {0.5, 3.0}, depth_m = {3.0, 9.0};
	// What a passage leads to is wider than itself.
	if (group.doors.front()->verdict == Verdict::passage) beside_m = {0.4, std::max(1.0, beside_m.high)};
	if (std::ranges::any_of(group.doors, &DoorPlan::isAjar))
		beside_m = {kFreeBesideAjar_m, 3.0}, depth_m = {2.4, std::max(3.0, depth_m.high)};
	const Span along{std::max(group.reach.low, hull.low - sketch.draw(beside_m)),
	                 std::min(group.reach.high, hull.high + sketch.draw(beside_m))};
	return {wall.frame, along, {wall.thickness_m, wall.thickness_m + sketch.draw(depth_m)}};
}

/** Whether the door's leaf stands neither in a wall of the space nor before another doorway. */
bool leafFits(const DoorPlan& door, const Group& group, const WallPlan& wall, const Space& space)
{
	const Outline leaf = leafOutline(door, wall.thickness_m);
	const auto inside = [&space](const Eigen::Vector2d& corner)
	{ return corner.x() >= space.along.low && corner.x() <= space.along.high && corner.y() <= space.behind.high; };
	const auto covered = [&](const DoorPlan* other)
	{
		const Span behind{0, wall.thickness_m + kFreeBehindDoor_m};
		return other != &door && overlap(leaf, rectangleOutline({}, other->freeAlong(), behind));
	};
	return leaf.empty() || (std::ranges::all_of(leaf, inside) && std::ranges::none_of(group.doors, covered));
}

/** Leaves that do not fit are taken off. */
void fitLeaves(const Group& group, const WallPlan& wall, const Space& space)
{
	for (DoorPlan* door : group.doors)
		if (!door->leaf.toward_robot && !leafFits(*door, group, wall, space)) door->leaf.kind = LeafKind::none;
}

/** The way through and the leaf stay free of furniture. */
void keepFree(Sketch& sketch, const WallPlan& wall, const DoorPlan& door)
{
	sketch.floor_use.take(rectangleOutline(wall.frame, door.freeAlong(), {0, wall.thickness_m + kFreeBehindDoor_m}));
	Outline leaf = leafOutline(door, wall.thickness_m);
	for (Eigen::Vector2d& corner : leaf) corner = wall.frame.at(corner.x(), corner.y());
	if (!leaf.empty()) sketch.floor_use.take(std::move(leaf));
}

void buildDark(Sketch& sketch, const Space& space)
{
	const std::size_t soot = sketch.material("black_felt", kSoot);
	enclose(sketch, space, {Side::left, Side::far, Side::right}, "black_felt");
	// The lining's edges stay out of the doorway, and a sheet of it lies on the floor and under the ceiling.
	const Span along = space.along.grown(-0.001), behind = space.behind.grown(-0.001);
	sketch.block("black_floor", space.frame, along, behind, {0, 0.004}, soot);
	const double top_m = sketch.style.wall_height_m;
	sketch.block("black_ceiling", space.frame, along, behind, {top_m - 0.01, top_m - 0.001}, soot);
	sketch.block("black_lining", space.frame, {along.low, along.low + 0.01}, behind, {0, top_m}, soot);
}

/** Steps downward straight on, or a bare shaft. */
void buildStairwell(Sketch& sketch, const WallPlan& wall, const Group& group)
{
	Random& random = sketch.random;
	const double landing_m = random.uniform(0.0, 0.2), rise_m = random.uniform(0.16, 0.2);
	const double run_m = random.uniform(0.25, 0.3), drop_m = random.uniform(1.6, 3.0);
	const Span hull = group.hull().grown(random.uniform(0.02, 0.6));
	const Span along{std::max(group.reach.low, hull.low), std::min(group.reach.high, hull.high)};
	const double edge_m = wall.thickness_m + landing_m;
	const int steps = static_cast<int>(drop_m / rise_m);
	const Span pit{edge_m, edge_m + run_m * steps + random.uniform(0.8, 1.5)};
	enclose(sketch, {wall.frame, along, {wall.thickness_m, pit.high}}, {Side::left, Side::far, Side::right});
	sketch.floor_holes.push_back(rectangleOutline(wall.frame, along, pit));

	const std::size_t stone = sketch.material("stone", kStone);
	constexpr double kThick_m = 0.1;
	const Span depth{-drop_m - kThick_m, 0};
	sketch.block("shaft", wall.frame, along, pit, {-drop_m - kThick_m, -drop_m}, stone);
	sketch.block("shaft", wall.frame, along, {pit.low - kThick_m, pit.low}, depth, stone);
	sketch.block("shaft", wall.frame, along, {pit.high, pit.high + kThick_m}, depth, stone);
	for (const double side_m : {along.low - kThick_m, along.high})
		sketch.block("shaft", wall.frame, {side_m, side_m + kThick_m}, pit, depth, stone);
	if (random.chance(0.25)) return;
	for (int step = 1; step < steps; ++step)
	{
		const double from_m = edge_m + run_m * (step - 1);
		sketch.block("step", wall.frame, along, {from_m, from_m + run_m}, {-drop_m, -rise_m * step}, stone);
	}
}
}  // namespace

void buildBeyond(Sketch& sketch, const WallPlan& wall, std::vector<DoorPlan>& doors, const Span& limits, int things)
{
	for (const Group& group : groupsOf(sketch, doors, limits, wall.thickness_m))
	{
		if (group.beyond() == Beyond::nothing) continue;
		if (group.beyond() == Beyond::stairwell)
		{
			buildStairwell(sketch, wall, group);
			continue;
		}
		const Space space = drawSpace(sketch, wall, group);
		fitLeaves(group, wall, space);
		if (group.beyond() == Beyond::dark)
		{
			buildDark(sketch, space);
			continue;
		}
		enclose(sketch, space, {Side::left, Side::far, Side::right});
		for (const DoorPlan* door : group.doors) keepFree(sketch, wall, *door);
		decorate(sketch, space, {Side::left, Side::far, Side::right});
		furnish(sketch, space, sketch.random.integer(0, things));
	}
}
}  // namespace explore::simulation
