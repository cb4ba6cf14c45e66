#include "support/building_groups.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore::test
{
void addCupboards(RoomSpace& space, int count, double most_high_m)
{
	for (int i = 0; i < count; ++i)
	{
		const PlanSize size(space.dice.between(0.35, 0.6), space.dice.between(0.5, 1.6));
		const double height = space.dice.between(0.7, std::min(most_high_m, space.plan.height_m - 0.1));
		const bool open = space.dice.chance(0.4);
		space.atWall(size,
		             [&](const Place& place)
		             {
			             if (open)
				             buildShelf(space.sketch, place, size, height, space.dice);
			             else
				             buildCupboard(space.sketch, place, size, height, space.dice);
		             });
	}
}

void addChairs(RoomSpace& space, int count)
{
	for (int i = 0; i < count; ++i)
		space.free(
		    {0.5, 0.5}, [&](const Place& place) { buildChair(space.sketch, place, space.dice); }, 0.1);
}

void addTableGroup(RoomSpace& space, const PlanSize& size, bool turned)
{
	const PlanSize all(size.x() + 1.2, size.y() + 0.2);
	space.free(
	    all,
	    [&](const Place& place)
	    {
		    buildTable(space.sketch, place, size, space.dice.between(0.71, 0.77), space.dice);
		    const int a_side = std::max(1, static_cast<int>(size.y() / 0.65));
		    for (const double side : {-1.0, 1.0})
			    for (int i = 0; i < a_side; ++i)
				    if (space.dice.chance(0.85))
					    buildChair(space.sketch,
					               place.then({side * (0.5 * size.x() + space.dice.between(0.05, 0.25)),
					                           (i + 0.5) * size.y() / a_side - 0.5 * size.y()},
					                          (side > 0 ? std::numbers::pi : 0) + space.dice.between(-0.3, 0.3)),
					               space.dice);
	    },
	    0.3, turned);
}

void decorate(RoomSpace& space)
{
	for (int i = space.dice.whole(0, 3); i > 0; --i)
	{
		const PlanSize size(0.03, space.dice.between(0.4, 1.4));
		const double middle = space.dice.between(1.4, 1.7), high = space.dice.between(0.3, 0.9);
		const Look look = space.dice.chance(0.2) ? Look::black : Look::fabric;
		space.atWall(size,
		             [&](const Place& place) {
			             space.sketch.box("picture", look, place, {0, 0, middle}, {size.x(), size.y(), high});
		             });
	}
	if (space.dice.chance(0.4))
		space.atWall({0.5, 0.5}, [&](const Place& place) { buildPlant(space.sketch, place, space.dice); });
	if (space.dice.chance(0.35))
		space.atWall({0.1, space.dice.between(0.6, 1.8)},
		             [&](const Place& place) {
			             buildRadiator(space.sketch, place, {0.09, 1.0});
		             });
	if (space.dice.chance(0.25))
		space.atWall({0.3, 0.3},
		             [&](const Place& place) {
			             space.sketch.cylinder("bin", Look::metal, place, {0, 0, 0.2}, 0.13, 0.4);
		             });
	if (space.dice.chance(0.2)) addPeople(space, 1);
	if (space.dice.chance(0.2))
	{
		const PlanSize size(space.dice.between(0.35, 0.6), space.dice.between(1.5, 2.4));
		space.atWall(size,
		             [&](const Place& place)
		             {
			             buildAlcove(space.sketch, place, size, space.dice.between(0.75, 1.1),
			                         space.plan.height_m > 4 ? 2.5 : space.plan.height_m, space.dice);
		             });
	}
}

void addCurtains(RoomSpace& space, int count)
{
	for (int i = 0; i < count; ++i)
	{
		const double wide = space.dice.between(0.3, 1.2), top = std::min(2.3, space.plan.height_m - 0.1);
		space.atWall({0.12, wide},
		             [&](const Place& place)
		             {
			             for (double y = -0.5 * wide; y < 0.5 * wide; y += 0.08)
				             space.sketch.box("drape", Look::fabric, place, {0, y, 0.5 * top + 0.02},
				                              {0.012, 0.1, top - 0.04},
				                              std::fmod(std::abs(y), 0.16) < 0.08 ? 0.5 : -0.5);
		             });
	}
}

void addPeople(RoomSpace& space, int count)
{
	for (int i = 0; i < count; ++i)
		space.free(
		    {0.5, 0.5}, [&](const Place& place) { buildPerson(space.sketch, place, "person", space.dice); }, 0.1);
}

void addColumns(RoomSpace& space, int count)
{
	const double side = space.dice.between(0.25, 0.5);
	const bool round = space.dice.chance(0.5);
	const double height = space.plan.height_m;
	for (int i = 0; i < count; ++i)
		space.free(
		    {side, side},
		    [&](const Place& place)
		    {
			    if (round)
				    space.sketch.cylinder("column", Look::wall, place, {0, 0, 0.5 * height}, 0.5 * side, height);
			    else
				    space.sketch.box("column", Look::wall, {place.origin, 0}, {0, 0, 0.5 * height},
				                     {side, side, height});
		    },
		    0.35, false);
}

void layCarpet(RoomSpace& space)
{
	const Eigen::Vector2d size = 0.5 * space.room.inside.sizes();
	if (!space.dice.chance(0.4) || size.minCoeff() < 0.8) return;
	space.sketch.box("carpet", Look::fabric, {space.room.inside.center(), 0}, {0, 0, 0.005},
	                 {size.x(), size.y(), 0.01});
}

void addDesk(RoomSpace& space)
{
	const PlanSize size(0.8, space.dice.between(1.2, 1.8));
	space.atWall({size.x() + 0.6, size.y()},
	             [&](const Place& place)
	             {
		             buildTable(space.sketch, place.then({-0.3, 0}), size, space.dice.between(0.70, 0.76), space.dice);
		             buildSwivelChair(space.sketch,
		                              place.then({0.35, space.dice.between(-0.2, 0.2)}, space.dice.between(2, 4)),
		                              space.dice);
	             });
}
}  // namespace explore::test
