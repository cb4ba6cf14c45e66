// The three configurations of the paper's Fig. 3(b).
#include <explore/simulation/scenes/family_parts.h>
#include <explore/simulation/scenes/scene_corridor.h>
#include <explore/simulation/scenes/scene_rooms.h>

#include <array>

namespace explore::simulation
{
namespace
{
constexpr Span kWidth_m{0.8, 1.2};

void singleWallSingleDoor(Sketch& sketch)
{
	drawDoorway(sketch, drawDoor(sketch, kWidth_m), {{1.0, 4.9}, {0, 75}});
}

void singleWallMultipleDoors(Sketch& sketch)
{
	FrontPlan front;
	double from_m = 0;
	const int count = sketch.random.integer(2, 3);
	for (int i = 0; i < count; ++i)
	{
		DoorPlan door = drawDoor(sketch, kWidth_m);
		door.id = "door_" + std::to_string(i + 1);
		door.along_m = from_m + 0.5 * door.width_m;
		from_m += door.width_m + sketch.random.uniform(0.3, 1.5);
		front.side.doors.push_back(door);
	}
	const auto first = static_cast<std::size_t>(sketch.random.integer(0, count - 2));
	const DoorPlan &left = front.side.doors[first], &right = front.side.doors[first + 1];
	sketch.promise.visible_doors = {left.id, right.id};
	if (lookAt(sketch, {{}, {left.along().low, right.along().high}}, {{1.5, 4.6}, {0, 75}}))
		buildFront(sketch, std::move(front));
}

void multipleWallsMultipleDoors(Sketch& sketch)
{
	drawDoorCorridor(sketch, kWidth_m);
	sketch.promise.walls_with_visible_doors = 2;
}

const std::array kPaperFamilies = {
    SceneFamily{"single_wall_single_door", "the paper's first configuration: one door, 0-75 degrees off its normal",
                singleWallSingleDoor, Negative::no, false, "single_wall_single_door"},
    SceneFamily{"single_wall_multiple_doors", "the paper's second configuration: two or three doors in one wall",
                singleWallMultipleDoors, Negative::no, false, "single_wall_multiple_doors"},
    SceneFamily{"multiple_walls_multiple_doors",
                "the paper's third configuration: doors in both walls of a corridor, about 90 degrees off the view",
                multipleWallsMultipleDoors, Negative::no, false, "multiple_walls_multiple_doors"},
};
}  // namespace

std::span<const SceneFamily> paperFamilies()
{
	return kPaperFamilies;
}
}  // namespace explore::simulation
