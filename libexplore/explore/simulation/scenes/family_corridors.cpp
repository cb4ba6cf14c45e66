// Corridors, and rooms that are none.
#include <explore/simulation/scenes/family_parts.h>
#include <explore/simulation/scenes/scene_corridor.h>

#include <algorithm>
#include <array>

namespace explore::simulation
{
namespace
{
void sideDoors(Sketch& sketch)
{
	drawDoorCorridor(sketch, {0.7, 1.3});
	sketch.promise.walls_with_visible_doors = 1;
}

/** The corridor opens into a hall over its whole width. */
void corridorEnd(Sketch& sketch)
{
	Random& random = sketch.random;
	// Near enough to see both corners, and far enough to have them in the image.
	const double width_m = random.uniform(1.1, 2.6), nearest_m = width_m + 0.3;
	RoomPlan room = drawCorridor(sketch, {{width_m, width_m}, {nearest_m, std::max(nearest_m + 0.5, 4.6)}, {-10, 10}});
	DoorPlan end;
	end.id = "end_1";
	end.width_m = room.space.along.length();
	end.along_m = 0.5 * end.width_m;
	end.top_m.reset();
	if (random.chance(0.4)) end.top_m = random.uniform(2.05, 2.3);
	end.verdict = Verdict::passage;
	room[Side::far].doors.push_back(end);
	sketch.style.casing_depth_m = 0;
	sketch.promise.visible_doors.push_back(end.id);
	buildRoom(sketch, std::move(room));
}

void corridorWithoutDoors(Sketch& sketch)
{
	const double width_m = sketch.random.uniform(0.9, 2.8);
	buildRoom(sketch, drawCorridor(sketch, {{width_m, width_m}, {2.5 * width_m, 8 * width_m}, {-20, 20}}));
}

/** Wide or square: no direction in it. */
void roomWithoutDoors(Sketch& sketch)
{
	Random& random = sketch.random;
	RoomPlan room;
	const double width_m = random.uniform(3.0, 9.0);
	const double depth_m = width_m > 4.2 ? random.uniform(4.2, 9.0) : width_m * random.uniform(0.8, 1.25);
	room.space = {WallFrame{}, {0, width_m}, {0, depth_m}};
	room.things = 8;
	const double from_wall_m = sketch.robot.radius_m + 0.25;
	const Eigen::Vector2d place{sketch.draw(room.space.along.grown(-from_wall_m)),
	                            sketch.draw(room.space.behind.grown(-from_wall_m))};
	standAt(sketch, place, random.uniform(-std::numbers::pi, std::numbers::pi));
	buildRoom(sketch, std::move(room));
}

const std::array kCorridorFamilies = {
    SceneFamily{"corridor_side_doors", "a corridor with open doors 0.7-1.3 m wide in its side walls", sideDoors},
    SceneFamily{"corridor_end", "a corridor that opens into a hall", corridorEnd},
    SceneFamily{"corridor_no_doors", "a corridor without doors", corridorWithoutDoors, Negative::yes},
    SceneFamily{"room_no_corridor", "a furnished room without doors, and no corridor", roomWithoutDoors, Negative::yes},
};
}  // namespace

std::span<const SceneFamily> corridorFamilies()
{
	return kCorridorFamilies;
}
}  // namespace explore::simulation
