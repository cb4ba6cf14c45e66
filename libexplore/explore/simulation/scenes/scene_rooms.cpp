#include "scene_rooms.h"

#include <explore/simulation/scenes/scene_beyond.h>
#include <explore/simulation/scenes/scene_clutter.h>

#include <algorithm>

namespace explore::simulation
{
namespace
{
constexpr std::array kSides = {Side::near, Side::far, Side::left, Side::right};
constexpr double kOutdoors_m = 12.0;

/** The wall that stands forward of the rest of its line. */
void buildStep(Sketch& sketch, const RoomPlan& room, const WallPlan& wall, double step_m)
{
	if (step_m == 0 || room.sides[static_cast<std::size_t>(Side::far)].doors.empty()) return;
	const DoorPlan& door = room.sides[static_cast<std::size_t>(Side::far)].doors.front();
	const Span part = step_m > 0 ? Span{wall.along.low, door.along().low} : Span{door.along().high, wall.along.high};
	sketch.block("wall", wall.frame, part, {-std::abs(step_m), 0}, {0, wall.height_m}, sketch.material("plaster"));
}
}  // namespace

WallPlan wallOf(Sketch& sketch, const RoomPlan& room, Side side)
{
	return plainWall(sketch, faceOf(room.space, side),
	                 Span{0, lengthOf(room.space, side)}.grown(sketch.style.wall_thickness_m));
}

void buildRoom(Sketch& sketch, RoomPlan room)
{
	sketch.robot_space = room.space;
	const auto sides_with_doors =
	    std::count_if(room.sides.begin(), room.sides.end(), [](const SidePlan& side) { return !side.doors.empty(); });
	for (const Side side : kSides)
	{
		SidePlan& plan = room[side];
		WallPlan wall = wallOf(sketch, room, side);
		const Span length{0, lengthOf(room.space, side)};
		buildBeyond(sketch, wall, plan.doors, sides_with_doors > 1 ? length : length.grown(kOutdoors_m), room.things);
		wall.openings = plan.openings;
		for (const DoorPlan& door : plan.doors)
		{
			buildDoor(sketch, wall, door);
			if (door.hole) wall.openings.push_back(openingOf(door, wall));
		}
		buildWall(sketch, wall);
	}
	labelCorridor(sketch, room.space);
	if (room.decorated) decorate(sketch, room.space, {Side::near, Side::far, Side::left, Side::right});
	furnish(sketch, room.space, sketch.random.integer(0, room.things));
}

void buildFront(Sketch& sketch, FrontPlan front)
{
	constexpr double kAroundRobot_m = 0.6, kBesideDoor_m = 0.12;
	const Eigen::Vector2d robot = sketch.robotPosition();
	Span along{std::min(robot.x() - kAroundRobot_m, front.extent.low - kBesideDoor_m),
	           std::max(robot.x() + kAroundRobot_m, front.extent.high + kBesideDoor_m)};
	for (const DoorPlan& door : front.side.doors)
	{
		along.low = std::min(along.low, door.along().low - kBesideDoor_m);
		along.high = std::max(along.high, door.along().high + kBesideDoor_m);
	}
	const auto spare = [&sketch] { return sketch.random.uniform(0.0, 2.5); };
	along.low = front.low_m.value_or(along.low - spare());
	along.high = front.high_m.value_or(along.high + spare());

	RoomPlan room;
	room.space = {WallFrame{}, along, {robot.y() - kAroundRobot_m - spare(), 0}};
	room.things = front.things;
	room.decorated = front.decorated;
	for (DoorPlan& door : front.side.doors) door.along_m -= along.low;
	for (Opening& opening : front.side.openings) opening.along.low -= along.low, opening.along.high -= along.low;
	room[Side::far] = front.side;
	buildStep(sketch, room, wallOf(sketch, room, Side::far), front.step_m);
	buildRoom(sketch, std::move(room));
}

void drawDoorway(Sketch& sketch, const DoorPlan& door, const ViewRange& range, FrontPlan front)
{
	if (!lookAt(sketch, {WallFrame{}, door.along()}, range)) return;
	sketch.promise.visible_doors.push_back(door.id);
	front.side.doors.push_back(door);
	buildFront(sketch, std::move(front));
}
}  // namespace explore::simulation
