#include "support/building_plan.h"

#include <algorithm>
#include <stdexcept>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;

struct Range
{
	double low, high;
};

/** Heights of rooms and thicknesses of walls of one kind of building [m]. */
struct PlanRanges
{
	Range height_m, outer_m, inner_m, corridor_m;
};

Plan emptyPlan(const PlanRanges& ranges, Dice& dice)
{
	const auto drawn = [&dice](const Range& range) { return dice.between(range.low, range.high); };
	Plan plan;
	plan.height_m = drawn(ranges.height_m);
	plan.outer_m = drawn(ranges.outer_m);
	plan.inner_m = drawn(ranges.inner_m);
	plan.corridor_m = drawn(ranges.corridor_m);
	return plan;
}

void addRoom(Plan& plan, Use use, double x0, double y0, double x1, double y1)
{
	Room room;
	room.use = use;
	room.axes = Area(Vector2d(x0, y0), Vector2d(x1, y1));
	plan.rooms.push_back(std::move(room));
}

/** Cuts an area into rooms that are not too narrow. */
void splitArea(Plan& plan, const Area& area, double wanted_m2, double narrowest_m, Dice& dice)
{
	const Vector2d size = area.sizes();
	const bool across = size.x() > size.y() * dice.between(0.85, 1.15);
	const double length = across ? size.x() : size.y();
	if (area.volume() < wanted_m2 * dice.between(0.9, 1.6) || length < 2 * narrowest_m + 0.2)
	{
		addRoom(plan, Use::bedroom, area.min().x(), area.min().y(), area.max().x(), area.max().y());
		return;
	}
	const double cut = dice.between(std::max(narrowest_m, 0.3 * length), length - std::max(narrowest_m, 0.3 * length));
	Area first = area, second = area;
	const int axis = across ? 0 : 1;
	first.max()[axis] = area.min()[axis] + cut;
	second.min()[axis] = first.max()[axis];
	splitArea(plan, first, wanted_m2, narrowest_m, dice);
	splitArea(plan, second, wanted_m2, narrowest_m, dice);
}

Plan houseOf(Dice& dice)
{
	Plan plan = emptyPlan({{2.35, 2.9}, {0.24, 0.40}, {0.07, 0.15}, {0.10, 0.24}}, dice);
	splitArea(plan, Area(Vector2d(0, 0), Vector2d(dice.between(11, 15), dice.between(9, 12))), 15, 2.0, dice);
	std::vector<Room*> by_size;
	for (Room& room : plan.rooms) by_size.push_back(&room);
	std::stable_sort(by_size.begin(), by_size.end(),
	                 [](const Room* a, const Room* b) { return a->axes.volume() > b->axes.volume(); });
	by_size.front()->use = Use::living;
	by_size[1]->use = Use::kitchen;
	by_size.back()->use = Use::bath;
	if (by_size.size() > 4) by_size[by_size.size() - 2]->use = Use::storage;
	if (by_size.size() > 5 && dice.chance(0.7))
		by_size[by_size.size() - 3]->use = dice.chance(0.5) ? Use::stairs_down : Use::stairs_up;
	return plan;
}

struct Row
{
	double from_x, to_x, near_y, far_y;  ///< near = at the corridor
};

/** Rooms side by side along a corridor, here and there a corridor that branches off. */
void addRow(Plan& plan, const Row& row, double narrow_m, double wide_m, std::initializer_list<Use> uses, Dice& dice,
            double branch_m)
{
	bool branched = branch_m <= 0;
	const double low_y = std::min(row.near_y, row.far_y), high_y = std::max(row.near_y, row.far_y);
	for (double x = row.from_x; x < row.to_x - 0.5;)
	{
		const bool branch = !branched && x > row.from_x + 5 && dice.chance(0.4);
		double width = branch ? branch_m : dice.between(narrow_m, wide_m);
		if (row.to_x - x - width < narrow_m) width = row.to_x - x;
		const bool room_for_branch = width < branch_m + 0.1;
		const Use use = branch && room_for_branch ? Use::corridor : dice.oneOf(uses);
		branched = branched || branch;
		addRoom(plan, use, x, low_y, x + width, high_y);
		x += width;
	}
}

/** A spine corridor with rooms on both sides, a hall at one end and perhaps one at the other. */
struct SpineSizes
{
	double length_m, corridor_m, depth_m, narrow_m, wide_m, hall_m, end_m;
};

void addSpine(Plan& plan, const SpineSizes& sizes, std::initializer_list<Use> uses, bool one_sided, Dice& dice)
{
	const double half = 0.5 * sizes.corridor_m, far = half + sizes.depth_m, low = one_sided ? -half : -far;
	const double end = sizes.hall_m + sizes.length_m;
	addRoom(plan, Use::hall, 0, low, sizes.hall_m, far);
	addRoom(plan, Use::corridor, sizes.hall_m, -half, end, half);
	if (sizes.end_m > 0) addRoom(plan, Use::hall, end, low, end + sizes.end_m, far);
	const double branch = dice.chance(0.7) ? dice.between(1.5, 2.2) : 0;
	addRow(plan, {sizes.hall_m, end, half, far}, sizes.narrow_m, sizes.wide_m, uses, dice, branch);
	if (!one_sided) addRow(plan, {sizes.hall_m, end, -half, -far}, sizes.narrow_m, sizes.wide_m, uses, dice, 0);
}

void turnSomeToStairs(Plan& plan, Dice& dice)
{
	int left = 2;
	for (Room& room : plan.rooms)
		if (left > 0 && room.use == Use::storage && room.axes.sizes().x() < 4.5)
		{
			room.use = left == 2 ? Use::stairs_down : Use::stairs_up;
			left -= dice.whole(1, 2);
		}
}

Plan officeOf(Dice& dice)
{
	Plan plan = emptyPlan({{2.5, 3.2}, {0.25, 0.40}, {0.08, 0.14}, {0.10, 0.20}}, dice);
	const double end = dice.chance(0.5) ? dice.between(8.5, 10) : 0;
	addSpine(plan,
	         {dice.between(15, 22), dice.between(1.6, 2.5), dice.between(4, 6.5), 2.6, 6.0, dice.between(5, 8), end},
	         {Use::office, Use::office, Use::office, Use::meeting, Use::storage, Use::bath}, false, dice);
	turnSomeToStairs(plan, dice);
	return plan;
}

Plan schoolOf(Dice& dice)
{
	Plan plan = emptyPlan({{2.9, 3.6}, {0.30, 0.40}, {0.14, 0.24}, {0.20, 0.36}}, dice);
	addSpine(
	    plan, {dice.between(24, 30), dice.between(2.5, 3.6), dice.between(6.5, 7.5), 3.2, 9.0, dice.between(7, 10), 0},
	    {Use::classroom, Use::classroom, Use::classroom, Use::storage, Use::office, Use::bath}, dice.chance(0.5), dice);
	turnSomeToStairs(plan, dice);
	return plan;
}

/** A guest's room: vestibule and bath at the corridor, the room behind them. */
void addGuestRoom(Plan& plan, double x0, double x1, double near_y, double far_y, Dice& dice)
{
	const double inward = far_y > near_y ? 1 : -1, deep = near_y + inward * dice.between(2.1, 2.6);
	const double entry = dice.between(1.35, 1.6);
	const bool entry_first = dice.chance(0.5);
	const double cut = entry_first ? x0 + entry : x1 - entry;
	const auto low = [](double a, double b) { return std::min(a, b); };
	const auto high = [](double a, double b) { return std::max(a, b); };
	addRoom(plan, entry_first ? Use::vestibule : Use::bath, x0, low(near_y, deep), cut, high(near_y, deep));
	addRoom(plan, entry_first ? Use::bath : Use::vestibule, cut, low(near_y, deep), x1, high(near_y, deep));
	addRoom(plan, Use::guest, x0, low(deep, far_y), x1, high(deep, far_y));
}

Plan hotelOf(Dice& dice)
{
	Plan plan = emptyPlan({{2.4, 2.8}, {0.24, 0.36}, {0.10, 0.20}, {0.15, 0.25}}, dice);
	const double half = 0.5 * dice.between(1.6, 2.1), far = half + dice.between(6, 7.5), hall = dice.between(5, 8);
	const int modules = dice.whole(4, 5);
	const double width = dice.between(3.5, 4.3), end = hall + modules * width;
	addRoom(plan, Use::hall, 0, -far, hall, far);
	addRoom(plan, Use::corridor, hall, -half, end, half);
	for (int i = 0; i < modules; ++i)
		for (const double side : {-1.0, 1.0})
		{
			const double x0 = hall + i * width, x1 = i + 1 == modules ? end : x0 + width;
			if (dice.chance(0.12))
				addRoom(plan, dice.chance(0.5) ? Use::stairs_down : Use::storage, x0, std::min(side * half, side * far),
				        x1, std::max(side * half, side * far));
			else
				addGuestRoom(plan, x0, x1, side * half, side * far, dice);
		}
	return plan;
}

Plan warehouseOf(Dice& dice)
{
	Plan plan = emptyPlan({{4.5, 6.5}, {0.20, 0.40}, {0.10, 0.24}, {0.12, 0.24}}, dice);
	const double long_m = dice.between(18, 26), wide_m = dice.between(13, 18), strip = dice.between(4, 5);
	addRoom(plan, Use::warehouse, 0, 0, long_m, wide_m);
	addRow(plan, {0, long_m, 0, -strip}, 2.8, 6.5, {Use::office, Use::storage, Use::storage, Use::bath, Use::meeting},
	       dice, dice.between(1.5, 2.2));
	if (dice.chance(0.7)) addRoom(plan, Use::warehouse, long_m, 0, long_m + dice.between(8, 11), wide_m);
	turnSomeToStairs(plan, dice);
	return plan;
}
}  // namespace

Plan planOf(std::string_view kind, Dice& dice)
{
	if (kind == "house") return houseOf(dice);
	if (kind == "office") return officeOf(dice);
	if (kind == "school") return schoolOf(dice);
	if (kind == "warehouse") return warehouseOf(dice);
	if (kind == "hotel") return hotelOf(dice);
	throw std::invalid_argument("a building is a house, office, school, warehouse or hotel, not \"" +
	                            std::string(kind) + "\"");
}
}  // namespace explore::test
