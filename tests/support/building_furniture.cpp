#include "support/building_furniture.h"

#include "support/building_groups.h"

#include <algorithm>
#include <numbers>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;

/** Facing walls at most 4 m apart are what the truth calls a corridor, where they are long enough. */
void labelCorridors(Sketch& sketch, const Room& room)
{
	const Vector2d size = room.inside.sizes(), middle = room.inside.center();
	for (const int axis : {0, 1})
	{
		const double width = size[1 - axis];
		if (width < 0.8 || width > 4.0) continue;
		PlannedCorridor corridor{middle, middle, width};
		corridor.from[axis] = room.inside.min()[axis];
		corridor.to[axis] = room.inside.max()[axis];
		sketch.corridors.push_back(corridor);
	}
}

void furnishLiving(RoomSpace& space)
{
	layCarpet(space);
	const double wide = space.dice.between(1.5, 2.3);
	space.atWall({0.9, wide}, [&](const Place& place) { buildSofa(space.sketch, place, {0.88, wide}); });
	addTableGroup(space, {0.9, space.dice.between(1.2, 2.0)}, space.dice.chance(0.3));
	space.free({0.6, 1.0}, [&](const Place& place) { buildTable(space.sketch, place, {0.6, 1.0}, 0.42, space.dice); });
	if (space.dice.chance(0.6))
		space.atWall({0.4, 0.4}, [&](const Place& place) { buildLamp(space.sketch, place, space.dice); });
	addCupboards(space, space.dice.whole(1, 3), 2.2);
	addCurtains(space, 1);
	decorate(space);
}

void furnishBedroom(RoomSpace& space)
{
	const double wide = space.dice.between(0.95, 1.85);
	space.atWall({2.05, wide}, [&](const Place& place) { buildBed(space.sketch, place, {2.04, wide}); });
	addCupboards(space, space.dice.whole(1, 2), 2.3);
	if (space.dice.chance(0.5)) addDesk(space);
	addCurtains(space, space.dice.whole(0, 1));
	decorate(space);
}

void furnishKitchen(RoomSpace& space)
{
	for (int i = 0; i < 2; ++i)
	{
		const double wide = space.dice.between(1.2, 2.6);
		space.atWall({0.6, wide},
		             [&](const Place& place)
		             {
			             space.sketch.box("kitchen", Look::white, place, {0, 0, 0.48}, {0.58, wide, 0.78});
			             space.sketch.box("kitchen", Look::white, place, {-0.03, 0, 0.05}, {0.5, wide, 0.10});
			             space.sketch.box("worktop", Look::wood, place, {0, 0, 0.89}, {0.6, wide, 0.04});
			             space.sketch.box("kitchen", Look::white, place, {-0.12, 0, 1.75}, {0.34, wide, 0.7});
		             });
	}
	space.atWall({0.62, 0.6},
	             [&](const Place& place) {
		             buildCupboard(space.sketch, place, {0.6, 0.6}, 1.8, space.dice);
	             });
	addTableGroup(space, {0.8, 1.2}, false);
	decorate(space);
}

void furnishBath(RoomSpace& space)
{
	space.atWall({0.66, 0.5}, [&](const Place& place) { buildToilet(space.sketch, place); });
	space.atWall({0.46, 0.6}, [&](const Place& place) { buildBasin(space.sketch, place); });
	if (space.room.inside.volume() > 6)
		space.atWall({0.75, 1.7},
		             [&](const Place& place) {
			             space.sketch.box("tub", Look::white, place, {0, 0, 0.28}, {0.74, 1.68, 0.56});
		             });
}

void furnishOffice(RoomSpace& space)
{
	for (int i = std::max(1, static_cast<int>(space.room.inside.volume() / 9)); i > 0; --i) addDesk(space);
	addCupboards(space, space.dice.whole(1, 3), 2.1);
	decorate(space);
}

void furnishMeeting(RoomSpace& space)
{
	addTableGroup(space, {1.1, std::max(1.4, 0.45 * space.room.inside.sizes().minCoeff())}, space.dice.chance(0.3));
	addCupboards(space, 1, 1.2);
	decorate(space);
}

void furnishClassroom(RoomSpace& space)
{
	const Area inside = space.room.inside;
	for (double x = inside.min().x() + 1.6; x < inside.max().x() - 1.2; x += 1.9)
		for (double y = inside.min().y() + 1.6; y < inside.max().y() - 1.2; y += 1.6)
		{
			if (space.dice.chance(0.15)) continue;
			const Place place{{x + space.dice.between(-0.1, 0.1), y}, space.dice.between(-0.1, 0.1)};
			if (!space.take(
			        Area(Vector2d(place.origin - Vector2d(0.7, 0.72)), Vector2d(place.origin + Vector2d(0.7, 0.72)))))
				continue;
			buildTable(space.sketch, place, {0.55, 1.3}, 0.74, space.dice);
			for (const double side : {-0.33, 0.33})
				buildChair(space.sketch, place.then({0.45, side}, std::numbers::pi), space.dice);
		}
	space.atWall({0.06, 3.0},
	             [&](const Place& place) {
		             space.sketch.box("writing_board", Look::leaves, place, {0, 0, 1.5}, {0.05, 3.0, 1.2});
	             });
	addCupboards(space, space.dice.whole(1, 3), 2.0);
	decorate(space);
}

void furnishCorridor(RoomSpace& space)
{
	const double width = space.room.inside.sizes().minCoeff(), spare = width - 1.3;
	if (spare > 0.25)
		for (int i = space.dice.whole(0, 5); i > 0; --i)
		{
			const PlanSize size(std::min(spare, space.dice.between(0.25, 0.5)), space.dice.between(0.8, 2.4));
			const double height = space.dice.chance(0.5) ? space.dice.between(1.6, 1.95) : 0.45;
			space.atWall(size,
			             [&](const Place& place) { buildCupboard(space.sketch, place, size, height, space.dice); });
		}
	decorate(space);
	if (space.dice.chance(0.4)) addPeople(space, 1);
}

void furnishHall(RoomSpace& space)
{
	addColumns(space, space.dice.whole(0, 4));
	for (int i = space.dice.whole(0, 2); i > 0; --i) addTableGroup(space, {0.8, space.dice.between(0.8, 1.6)}, true);
	for (int i = space.dice.whole(0, 2); i > 0; --i)
		space.atWall({0.85, 1.6}, [&](const Place& place) { buildSofa(space.sketch, place, {0.84, 1.58}); });
	space.free({0.7, 2.2},
	           [&](const Place& place) {
		           space.sketch.box("desk", Look::wood, place, {0, 0, 0.55}, {0.7, 2.2, 1.1});
	           });
	addChairs(space, space.dice.whole(0, 4));
	addPeople(space, space.dice.whole(0, 3));
	addCupboards(space, space.dice.whole(0, 2), 2.0);
	decorate(space);
}

void furnishStorage(RoomSpace& space)
{
	addCupboards(space, space.dice.whole(1, 4), 2.2);
	for (int i = space.dice.whole(0, 3); i > 0; --i)
		space.atWall({0.6, 0.6},
		             [&](const Place& place) {
			             space.sketch.box("carton", Look::cardboard, place, {0, 0, 0.25}, {0.5, 0.45, 0.5});
		             });
}

void furnishWarehouse(RoomSpace& space)
{
	const double deep = space.dice.between(0.9, 1.2), aisle = space.dice.between(2.4, 3.6),
	             height = space.dice.between(2.5, 4.5);
	for (double y = space.room.inside.min().y() + 2.5; y + deep < space.room.inside.max().y() - 2; y += deep + aisle)
		for (double x = space.room.inside.min().x() + 2.5; x + 4 < space.room.inside.max().x() - 2.5;)
		{
			const double length = space.dice.between(4, 8),
			             to = std::min(x + length, space.room.inside.max().x() - 2.5);
			const Area area(Vector2d(x, y), Vector2d(to, y + deep));
			if (to - x > 2 && space.dice.chance(0.8) && space.take(area))
				buildRack(space.sketch, {area.center(), std::numbers::pi / 2}, {deep, to - x}, height, space.dice);
			x = to + space.dice.between(1.5, 3);
		}
	addColumns(space, space.dice.whole(0, 4));
	for (int i = space.dice.whole(2, 8); i > 0; --i)
		space.free(
		    {1.3, 0.9}, [&](const Place& place) { buildPallet(space.sketch, place, space.dice); }, 0.2,
		    space.dice.chance(0.3));
	addPeople(space, space.dice.whole(1, 3));
}
}  // namespace

void furnish(Sketch& sketch, Plan& plan, Room& room, Dice& dice)
{
	labelCorridors(sketch, room);
	RoomSpace space{sketch, plan, room, dice};
	switch (room.use)
	{
		case Use::living:
			furnishLiving(space);
			break;
		case Use::bedroom:
		case Use::guest:
			furnishBedroom(space);
			break;
		case Use::kitchen:
			furnishKitchen(space);
			break;
		case Use::bath:
			furnishBath(space);
			break;
		case Use::office:
			furnishOffice(space);
			break;
		case Use::meeting:
			furnishMeeting(space);
			break;
		case Use::classroom:
			furnishClassroom(space);
			break;
		case Use::corridor:
			furnishCorridor(space);
			break;
		case Use::hall:
			furnishHall(space);
			break;
		case Use::storage:
			furnishStorage(space);
			break;
		case Use::warehouse:
			furnishWarehouse(space);
			break;
		default:
			break;
	}
}
}  // namespace explore::test
