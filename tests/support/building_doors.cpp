#include "support/building_doors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;

constexpr double kDegree_rad = std::numbers::pi / 180;
constexpr double kWay_m = 1.3;      ///< before a door, kept free of furniture
constexpr double kBetween_m = 0.2;  ///< wall between two openings at least

Area areaOf(const BuildingWall& wall, const Footprint& footprint)
{
	Area area;
	for (const Vector2d& corner : footprint) area.extend(wall.frame.start.at(corner));
	return area;
}

/** Near what the robots need (0.54 m and 0.70 m): whether they fit would be a matter of millimetres. */
bool doubtful(double clear_m)
{
	constexpr double kDoubt_m = 0.04;
	return std::abs(clear_m - 0.54) < kDoubt_m || std::abs(clear_m - 0.70) < kDoubt_m;
}

bool isDoor(const Opening& opening)
{
	return opening.filling != Filling::window && opening.filling != Filling::niche;
}

bool touchesAny(const Area& area, const std::vector<Area>& others)
{
	return std::any_of(others.begin(), others.end(), [&](const Area& other) { return area.intersects(other); });
}
}  // namespace

Area BuildingWall::before(double from, double to, int side, double depth_m) const
{
	const double face = side * 0.5 * frame.thickness_m, far = face + side * depth_m;
	Area area;
	for (const double x : {from, to})
		for (const double y : {face, far}) area.extend(frame.start.at({x, y}));
	return area;
}

DoorStyle doorStyleOf(const Plan& plan, Dice& dice)
{
	DoorStyle style;
	style.height_m = std::min(dice.between(1.96, 2.14), plan.height_m - 0.15);
	if (dice.chance(0.75))
	{
		style.casing_m = dice.between(0.04, 0.10);
		style.casing_proud_m = dice.between(0.01, 0.03);
	}
	style.stop_m = dice.chance(0.7) ? dice.between(0.008, 0.015) : 0;
	style.threshold_share = dice.chance(0.5) ? dice.between(0.1, 0.6) : 0;
	return style;
}

Opening DoorHanger::basic(double width_m)
{
	Opening opening;
	opening.id = std::string("d").append(std::to_string(m_doors));
	opening.width_m = width_m;
	opening.high_m =
	    m_dice.chance(0.85) ? m_style.height_m : std::min(m_dice.between(1.95, 2.35), m_plan.height_m - 0.1);
	opening.low_m = m_dice.chance(m_style.threshold_share) ? m_dice.between(0.01, 0.03) : 0;
	opening.casing_m = m_style.casing_m;
	opening.casing_proud_m = m_style.casing_proud_m;
	opening.side = m_dice.chance(0.5) ? 1 : -1;
	opening.hinge_left = m_dice.chance(0.5);
	return opening;
}

void DoorHanger::hangLeaf(Opening& opening, const BuildingWall& wall)
{
	const double room_m = wall.frame.thickness_m - kLeaf_m - 0.01;
	opening.stop_m = room_m > 0.035 ? m_style.stop_m : 0;
	opening.recess_m = room_m > 0.05 && m_dice.chance(0.4) ? m_dice.between(0.01, room_m) : 0;
	if (opening.recess_m > room_m - 0.035) opening.stop_m = 0;
	if (m_dice.chance(0.25))
		opening.angle_rad = 0;
	else
		opening.angle_rad = kDegree_rad * (m_dice.chance(0.5) ? m_dice.between(6, 80) : m_dice.between(80, 176));
	if (opening.recess_m > 0 && opening.angle_rad > 90 * kDegree_rad)
		opening.angle_rad = kDegree_rad * m_dice.between(75, 90);
	const double looks = m_dice.between(0, 1);
	if (opening.angle_rad == 0 && looks < 0.10) opening.leaf_look = Look::glass;
	if (looks > 0.95) opening.leaf_look = Look::black;
	if (looks > 0.5 && looks < 0.7) opening.leaf_look = Look::white;
}

void DoorHanger::chooseSliding(Opening& opening, const BuildingWall& wall)
{
	// The opening's middle and that of what is left are near each other, so that both are its centre within 0.2 m.
	opening.filling =
	    wall.frame.thickness_m > 0.1 && m_dice.chance(0.5) ? Filling::sliding_wall : Filling::sliding_face;
	opening.casing_m = opening.filling == Filling::sliding_face ? 0 : opening.casing_m;
	const double choice = m_dice.between(0, 1);
	if (choice < 0.3)
		opening.slid_m = 0;
	else if (choice < 0.5)
		opening.slid_m = m_dice.between(0.2, 0.48);
	else
		opening.slid_m = m_dice.between(std::max(0.58, opening.width_m - 0.34), opening.width_m);
}

void DoorHanger::chooseState(Opening& opening, const BuildingWall& wall)
{
	const double choice = m_dice.between(0, 1);
	if (choice < 0.66)
	{
		opening.filling = Filling::leaf;
		return hangLeaf(opening, wall);
	}
	if (choice < 0.78) return;  // no leaf
	if (choice < 0.83)
	{
		opening.arch_m = m_dice.between(0.1, 0.35);
		opening.high_m = std::min(1.85 + opening.arch_m + m_dice.between(0, 0.2), m_plan.height_m - 0.1);
		return;
	}
	if (choice < 0.90) return chooseSliding(opening, wall);
	if (choice < 0.93)
		opening.filling = Filling::curtain;
	else if (choice < 0.96)
		opening.filling = Filling::person;
	else
	{
		opening.filling = Filling::boxes;
		opening.slid_m = m_dice.between(0.05, 0.4);
	}
}

void DoorHanger::measureCorners(const BuildingWall& wall, Opening& opening) const
{
	const double from = opening.middle_m - 0.5 * opening.width_m, to = from + opening.width_m;
	opening.casing_at = {from - opening.casing_m > wall.from_m, to + opening.casing_m < wall.to_m};
	if (wall.roomAt(opening.side) < 0) return;
	const Area& inside = m_plan.rooms[static_cast<std::size_t>(wall.roomAt(opening.side))].inside;
	const int axis = wall.frame.start.yaw_rad == 0 ? 0 : 1;
	const double start = wall.frame.start.origin[axis];
	opening.corner_m = {start + from - inside.min()[axis], inside.max()[axis] - start - to};
}

std::optional<double> DoorHanger::freeMiddle(const BuildingWall& wall, double width_m, bool corner)
{
	const double edge = corner ? m_dice.between(0, 0.12) : m_dice.between(0.15, 0.3);
	const double from = wall.from_m + edge + 0.5 * width_m, to = wall.to_m - edge - 0.5 * width_m;
	if (from > to) return std::nullopt;
	double middle = m_dice.between(from, to);
	if (corner) middle = m_dice.chance(0.5) ? from : to;
	for (const Opening& other : wall.openings)
		if (std::abs(middle - other.middle_m) < 0.5 * (width_m + other.width_m) + kBetween_m) return std::nullopt;
	return middle;
}

bool DoorHanger::fits(const BuildingWall& wall, const Opening& whole) const
{
	const Opening opening = movingPartOf(whole);
	const double from = opening.middle_m - 0.5 * opening.width_m, to = from + opening.width_m;
	for (const int side : {1, -1})
	{
		if (wall.roomAt(side) < 0 || !isDoor(opening)) continue;
		const Room& room = m_plan.rooms[static_cast<std::size_t>(wall.roomAt(side))];
		if (touchesAny(wall.before(from + 0.05, to - 0.05, side, 0.6), room.leaves)) return false;
	}
	if (wall.roomAt(opening.side) < 0 && (opening.filling == Filling::leaf || opening.filling == Filling::two_leaves))
		return opening.angle_rad == 0;
	if (opening.angle_rad == 0 && opening.filling != Filling::sliding_face) return true;
	const double thickness = wall.frame.thickness_m;
	if (doubtful(clearWidthOf(opening, thickness))) return false;
	if (wall.roomAt(opening.side) < 0) return opening.filling != Filling::sliding_face;
	const Room& room = m_plan.rooms[static_cast<std::size_t>(wall.roomAt(opening.side))];
	for (const Footprint& leaf : leavesOf(opening, thickness))
	{
		const Area area = areaOf(wall, leaf);
		Area within = room.inside;
		within.extend(wall.before(wall.from_m, wall.to_m, opening.side, -thickness).min());
		within.extend(wall.before(wall.from_m, wall.to_m, opening.side, -thickness).max());
		if (!within.contains(area) || touchesAny(area, room.taken)) return false;
		// A leaf in a corridor must leave a way past it.
		const int across = wall.frame.start.yaw_rad == 0 ? 1 : 0;
		const double reach = area.sizes()[across];
		if (room.inside.sizes()[across] < reach + 0.75) return false;
		// And it may not lie before another opening of the same wall.
		for (const Opening& other : wall.openings)
		{
			const double a = other.middle_m - 0.5 * other.width_m, b = a + other.width_m;
			if (area.intersects(wall.before(a - 0.05, b + 0.05, opening.side, 0.6))) return false;
		}
	}
	return true;
}

void DoorHanger::take(BuildingWall& wall, Opening opening)
{
	const double from = opening.middle_m - 0.5 * opening.width_m, to = from + opening.width_m;
	if (isDoor(opening)) ++m_doors;
	for (const int side : {1, -1})
		if (wall.roomAt(side) >= 0)
		{
			Room& room = m_plan.rooms[static_cast<std::size_t>(wall.roomAt(side))];
			const bool way = isDoor(opening) && opening.filling != Filling::counter;
			// Past a leaf that is ajar the way leads aside.
			const bool aside =
			    way && opening.angle_rad > 0 && opening.angle_rad < 80 * kDegree_rad && side == opening.side;
			const double wider = aside ? 0.6 : 0.05;
			room.taken.push_back(wall.before(from - wider, to + wider, side, way ? kWay_m : 0.35));
		}
	if (wall.roomAt(opening.side) >= 0)
		for (const Footprint& leaf : leavesOf(movingPartOf(opening), wall.frame.thickness_m))
		{
			Room& room = m_plan.rooms[static_cast<std::size_t>(wall.roomAt(opening.side))];
			room.leaves.push_back(areaOf(wall, leaf));
			room.taken.push_back(areaOf(wall, leaf));
		}
	wall.openings.push_back(std::move(opening));
}

template <class MakeOpening>
bool DoorHanger::hang(BuildingWall& wall, const MakeOpening& make)
{
	constexpr int kTrials = 25;
	for (int i = 0; i < kTrials; ++i)
	{
		Opening opening = make();
		const auto middle = freeMiddle(wall, opening.width_m, m_dice.chance(0.25));
		if (!middle) continue;
		opening.middle_m = *middle;
		measureCorners(wall, opening);
		if (!fits(wall, opening)) continue;
		take(wall, std::move(opening));
		return true;
	}
	return false;
}

bool DoorHanger::door(BuildingWall& wall, double narrow_m, double wide_m)
{
	return hang(wall,
	            [&]
	            {
		            double width = m_dice.between(narrow_m, wide_m);
		            while (doubtful(width)) width = m_dice.between(narrow_m, wide_m + 0.1);
		            Opening opening = basic(width);
		            chooseState(opening, wall);
		            return opening;
	            });
}

bool DoorHanger::freeDoor(BuildingWall& wall, double narrow_m, double wide_m)
{
	return hang(wall,
	            [&]
	            {
		            Opening opening = basic(m_dice.between(narrow_m, wide_m));
		            if (m_dice.chance(0.3)) return opening;
		            opening.filling = Filling::leaf;
		            hangLeaf(opening, wall);
		            opening.angle_rad = kDegree_rad * m_dice.between(80, opening.recess_m > 0 ? 90 : 170);
		            return opening;
	            });
}

bool DoorHanger::closedDoor(BuildingWall& wall, double width_m, double height_m, Filling filling)
{
	return hang(wall,
	            [&]
	            {
		            Opening opening = basic(width_m);
		            opening.high_m = height_m;
		            opening.filling = filling;
		            opening.low_m = 0;
		            return opening;
	            });
}

bool DoorHanger::doubleDoor(BuildingWall& wall)
{
	return hang(wall,
	            [&]
	            {
		            const bool bolted = m_dice.chance(0.5);
		            Opening opening = basic(bolted ? m_dice.between(1.56, 1.95) : m_dice.between(1.2, 1.9));
		            opening.filling = bolted ? Filling::fixed_leaf : Filling::two_leaves;
		            if (m_dice.chance(0.8)) opening.angle_rad = kDegree_rad * m_dice.between(70, 175);
		            opening.passage = !bolted && opening.width_m > 1.45;
		            if (opening.angle_rad == 0 && m_dice.chance(0.3)) opening.leaf_look = Look::glass;
		            return opening;
	            });
}

bool DoorHanger::passage(BuildingWall& wall, double narrow_m, double wide_m, bool lintel, bool full)
{
	const double most = wall.to_m - wall.from_m - (full ? 0 : 0.4);
	if (most < std::max(narrow_m, 0.8)) return false;
	const auto make = [&]
	{
		Opening opening = basic(full ? most : std::min(m_dice.between(narrow_m, wide_m), most));
		opening.low_m = 0;
		opening.high_m = lintel ? std::min(m_dice.between(2.0, 2.5), m_plan.height_m - 0.12) : m_plan.height_m;
		opening.passage = !lintel || opening.width_m > 1.45;
		if (!lintel || full || m_dice.chance(0.5)) opening.casing_m = 0;
		if (lintel && m_dice.chance(0.25) && m_plan.height_m > 2.4)
		{
			opening.arch_m = m_dice.between(0.1, 0.4);
			opening.high_m = std::min(1.8 + opening.arch_m + m_dice.between(0.05, 0.3), m_plan.height_m - 0.1);
		}
		return opening;
	};
	if (!full) return hang(wall, make);
	if (!wall.openings.empty()) return false;
	Opening opening = make();
	opening.middle_m = 0.5 * (wall.from_m + wall.to_m);
	measureCorners(wall, opening);
	if (!fits(wall, opening)) return false;
	take(wall, std::move(opening));
	return true;
}

bool DoorHanger::window(BuildingWall& wall, bool to_floor)
{
	return hang(wall,
	            [&]
	            {
		            Opening opening = basic(m_dice.between(0.6, std::min(3.0, wall.to_m - wall.from_m)));
		            opening.filling = Filling::window;
		            opening.low_m = to_floor ? m_dice.between(0.0, 0.06) : m_dice.between(0.4, 1.1);
		            opening.high_m = std::min(m_dice.between(1.95, 2.4), m_plan.height_m - 0.1);
		            return opening;
	            });
}

bool DoorHanger::niche(BuildingWall& wall)
{
	const double most = wall.frame.thickness_m - 0.06;
	if (most < 0.1) return false;
	return hang(wall,
	            [&]
	            {
		            Opening opening = basic(m_dice.between(0.6, 1.2));
		            opening.filling = Filling::niche;
		            opening.depth_m = m_dice.between(0.08, most);
		            opening.low_m = m_dice.chance(0.6) ? 0 : m_dice.between(0.3, 1.0);
		            opening.side = wall.roomAt(opening.side) < 0 ? -opening.side : opening.side;
		            return opening;
	            });
}

bool DoorHanger::counter(BuildingWall& wall)
{
	return hang(wall,
	            [&]
	            {
		            Opening opening = basic(m_dice.between(0.9, 2.0));
		            opening.filling = Filling::counter;
		            opening.low_m = m_dice.between(0.85, 1.1);
		            return opening;
	            });
}

bool DoorHanger::dropDoor(BuildingWall& wall, int stairs_side)
{
	return hang(wall,
	            [&]
	            {
		            Opening opening = basic(m_dice.between(0.8, 1.1));
		            opening.drop = true;
		            opening.low_m = 0;
		            if (m_dice.chance(0.5)) return opening;
		            opening.filling = Filling::leaf;
		            hangLeaf(opening, wall);
		            opening.side = -stairs_side;
		            opening.angle_rad = m_dice.chance(0.7) ? kDegree_rad * m_dice.between(80, 90) : 0;
		            return opening;
	            });
}
}  // namespace explore::test
