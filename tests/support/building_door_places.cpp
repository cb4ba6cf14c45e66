#include "support/building_doors.h"
#include "support/building_leaves.h"

#include <explore/core/geometry.h>

#include <algorithm>
#include <cmath>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;

constexpr double kWay_m = 1.3;      ///< before a door, kept free of furniture
constexpr double kBetween_m = 0.2;  ///< wall between two openings at least

Area areaOf(const BuildingWall& wall, const Footprint& footprint)
{
	Area area;
	for (const Vector2d& corner : footprint) area.extend(wall.frame.start.at(corner));
	return area;
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

bool DoorHanger::doubtful(double clear_m)
{
	constexpr double kDoubt_m = 0.04;
	return std::abs(clear_m - 0.54) < kDoubt_m || std::abs(clear_m - 0.70) < kDoubt_m;
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

bool DoorHanger::hang(BuildingWall& wall, const std::function<Opening()>& make)
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
}  // namespace explore::test
