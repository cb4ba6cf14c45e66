#include "scene_corridor.h"

#include <explore/core/geometry.h>

#include <algorithm>
#include <cmath>

namespace explore::simulation
{
namespace
{
constexpr double kBetweenDoors_m = 0.4, kFromCorner_m = 0.2, kVisible_m = 4.95;

/** Which part of a side wall, in y, is in the image and near enough for a door. */
Span visiblePart(const Sketch& sketch, const RoomPlan& room, Side side)
{
	const Eigen::Vector2d camera = sketch.view.camera;
	const double wall_x = side == Side::left ? room.space.along.low : room.space.along.high;
	const double off_axis_rad = sketch.view.yaw_rad - 0.5 * std::numbers::pi;
	const double edge_rad =
	    sketch.halfView_rad() - 1.5 * kDegree_rad + (side == Side::left ? off_axis_rad : -off_axis_rad);
	const double across_m = std::abs(wall_x - camera.x());
	if (edge_rad <= 0.02) return {0, 0};
	return {camera.y() + across_m / std::tan(edge_rad),
	        camera.y() + std::sqrt(std::max(0.0, kVisible_m * kVisible_m - across_m * across_m))};
}

/** A face's along for the building's y on a side wall. */
double alongOf(const RoomPlan& room, Side side, double y)
{
	return side == Side::left ? y - room.space.behind.low : room.space.behind.high - y;
}

bool hasRoom(const SidePlan& plan, const Span& along, double length_m)
{
	if (along.low < kFromCorner_m || along.high > length_m - kFromCorner_m) return false;
	return std::none_of(plan.doors.begin(), plan.doors.end(),
	                    [&along](const DoorPlan& door) { return door.along().grown(kBetweenDoors_m).overlaps(along); });
}

void addDoors(Sketch& sketch, RoomPlan& room, Side side, const Span& width_m, const char* name)
{
	Random& random = sketch.random;
	SidePlan& plan = room[side];
	const double length_m = lengthOf(room.space, side);
	const Span visible = visiblePart(sketch, room, side);
	const int count = random.integer(1, 3);
	for (int i = 0; i < count; ++i)
	{
		DoorPlan door = drawDoor(sketch, width_m);
		door.id = std::string(name).append("_").append(std::to_string(i + 1));
		const Span reach = (i == 0 ? visible : room.space.behind).grown(-0.5 * door.width_m);
		if (reach.length() <= 0)
		{
			sketch.possible = sketch.possible && i > 0;
			continue;
		}
		door.along_m = alongOf(room, side, sketch.draw(reach));
		if (hasRoom(plan, door.along(), length_m)) plan.doors.push_back(door);
	}
}
}  // namespace

RoomPlan drawCorridor(Sketch& sketch, const CorridorDraw& draw)
{
	Random& random = sketch.random;
	RoomPlan room;
	const double width_m = sketch.draw(draw.width_m), passed_m = random.uniform(0.5, 4.0);
	room.space = {WallFrame{}, around(0, width_m), {0, passed_m + sketch.draw(draw.ahead_m)}};
	room.things = 3;
	const double from_wall_m = sketch.robot.radius_m + 0.12;
	const Span across = room.space.along.grown(-from_wall_m);
	const double yaw_rad = 0.5 * std::numbers::pi + sketch.drawAngle(draw.yaw_deg);
	standAt(sketch, {sketch.draw(across), passed_m}, yaw_rad);
	// The way ahead stays free, and one from end to end, as people keep their corridors.
	const Eigen::Vector2d robot = sketch.robotPosition();
	sketch.floor_use.take(rectangleOutline(WallFrame{robot, yaw_rad}, {0, 3.0}, around(0, 2 * from_wall_m)));
	sketch.floor_use.take(rectangleOutline(WallFrame{}, around(robot.x(), 2 * from_wall_m), room.space.behind));
	return room;
}

void drawDoorCorridor(Sketch& sketch, const Span& door_width_m)
{
	RoomPlan room = drawCorridor(sketch);
	addDoors(sketch, room, Side::left, door_width_m, "left");
	addDoors(sketch, room, Side::right, door_width_m, "right");
	DoorPlan end = drawDoor(sketch, door_width_m);
	end.id = "end_1";
	const Span reach = Span{0, room.space.along.length()}.grown(-0.5 * end.width_m - 0.1);
	if (sketch.random.chance(0.3) && reach.length() > 0)
	{
		end.along_m = sketch.draw(reach);
		room[Side::far].doors.push_back(end);
	}
	if (sketch.possible) buildRoom(sketch, std::move(room));
}
}  // namespace explore::simulation
