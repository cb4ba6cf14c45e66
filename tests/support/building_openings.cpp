// Which walls of a made-up building get which doors, passages and windows.
#include "support/building_doors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace explore::test
{
namespace
{
using Eigen::Vector2d;

class OpeningPlanner
{
public:
	OpeningPlanner(Plan& plan, std::string_view kind, Dice& dice)
	    : m_plan(plan), m_kind(kind), m_dice(dice), m_hanger(plan, dice)
	{
	}

	void run()
	{
		if (m_kind == "house")
			connectRooms();
		else
			for (BuildingWall& wall : m_plan.walls)
				if (wall.left >= 0 && wall.right >= 0) between(wall);
		for (BuildingWall& wall : m_plan.walls)
			if (wall.left < 0 || wall.right < 0) outer(wall);
		for (BuildingWall& wall : m_plan.walls)
			if (m_dice.chance(0.3) && !isStairs(useAt(wall, 1)) && !isStairs(useAt(wall, -1))) m_hanger.niche(wall);
	}

private:
	static bool isStairs(Use use) { return use == Use::stairs_down || use == Use::stairs_up; }
	static bool isWay(Use use) { return use == Use::corridor || use == Use::hall || use == Use::warehouse; }
	[[nodiscard]] Use useAt(const BuildingWall& wall, int side) const
	{
		const int room = wall.roomAt(side);
		return room < 0 ? Use::storage : m_plan.rooms[static_cast<std::size_t>(room)].use;
	}
	[[nodiscard]] Room& roomAt(const BuildingWall& wall, int side)
	{
		return m_plan.rooms[static_cast<std::size_t>(wall.roomAt(side))];
	}

	/** To stairs: either they begin right behind the door, or after a landing. */
	void stairs(BuildingWall& wall, int side)
	{
		Room& room = roomAt(wall, side);
		if (room.landing_m > 0) return;
		const bool along_x = wall.frame.start.yaw_rad == 0;
		const double deep = room.inside.sizes()[along_x ? 1 : 0];
		const bool drop = room.use == Use::stairs_down && (m_dice.chance(0.6) || deep < 3.0);
		if (!(drop ? m_hanger.dropDoor(wall, side) : m_hanger.freeDoor(wall, 0.8, 1.1))) return;
		room.landing_m = drop ? m_dice.between(0.02, 0.2) : m_dice.between(1.5, 1.8);
		// Seen from the stairs' room the door is at its low side where the room is on the wall's high side.
		const bool room_is_higher = along_x ? side > 0 : side < 0;
		room.way_down = along_x ? (room_is_higher ? 2 : 3) : (room_is_higher ? 0 : 1);
	}

	void between(BuildingWall& wall)
	{
		const Use left = useAt(wall, 1), right = useAt(wall, -1);
		for (const int side : {1, -1})
			if (isStairs(useAt(wall, side)))
			{
				if (isWay(useAt(wall, -side))) stairs(wall, side);
				return;
			}
		const auto pair = [&](Use a, Use b) { return (left == a && right == b) || (left == b && right == a); };
		const auto has = [&](Use use) { return left == use || right == use; };
		if (pair(Use::corridor, Use::hall) || pair(Use::corridor, Use::corridor) || pair(Use::corridor, Use::warehouse))
			mouth(wall);
		else if (pair(Use::hall, Use::hall) || pair(Use::warehouse, Use::warehouse))
			m_hanger.passage(wall, 2.2, 3.3, m_dice.chance(0.7));
		else if (pair(Use::vestibule, Use::guest))
			m_hanger.passage(wall, 0.85, 1.2, m_dice.chance(0.5));
		else if (has(Use::vestibule) && has(Use::bath))
			m_hanger.door(wall, 0.6, 0.85);
		else if (has(Use::vestibule) && isWay(left == Use::vestibule ? right : left))
			m_hanger.door(wall, 0.8, 1.0);
		else if (isWay(left) || isWay(right))
			toRoom(wall, isWay(left) ? right : left);
		else if (!has(Use::vestibule) && !has(Use::bath) && m_dice.chance(0.25))
			m_hanger.door(wall, 0.75, 1.0);
	}

	void mouth(BuildingWall& wall)
	{
		const double choice = m_dice.between(0, 1);
		if (choice < 0.45 && m_hanger.passage(wall, 1, 4, m_dice.chance(0.5), true)) return;
		if (choice < 0.75 && m_hanger.passage(wall, 1.0, 2.0, m_dice.chance(0.7))) return;
		if (!m_hanger.doubleDoor(wall)) m_hanger.door(wall, 0.85, 1.1);
	}

	void toRoom(BuildingWall& wall, Use room)
	{
		const bool hotel_room = room == Use::guest || (m_kind == "hotel" && room == Use::bath);
		if (hotel_room) return;
		const double length = wall.to_m - wall.from_m;
		if (m_kind == "school" && room == Use::classroom && m_dice.chance(0.3))
			m_hanger.doubleDoor(wall);
		else
			m_hanger.door(wall, room == Use::bath || room == Use::storage ? 0.6 : 0.76,
			              m_kind == "school" ? 1.15 : 1.02);
		if (length > 5 && m_dice.chance(0.4)) m_hanger.door(wall, 0.78, 1.0);
		if (room == Use::meeting || (room == Use::office && m_dice.chance(0.3)))
			m_hanger.window(wall, m_dice.chance(0.6));
		if (length > 3 && m_dice.chance(0.12)) m_hanger.counter(wall);
	}

	void outer(BuildingWall& wall)
	{
		const Use use = wall.left >= 0 ? useAt(wall, 1) : useAt(wall, -1);
		const double length = wall.to_m - wall.from_m;
		if (isStairs(use)) return;
		if (use == Use::warehouse)
		{
			const int gates = static_cast<int>(length / 7);
			for (int i = 0; i < gates; ++i)
				if (m_dice.chance(0.5)) m_hanger.closedDoor(wall, m_dice.between(2.4, 3.2), 3.2, Filling::sliding_wall);
			return;
		}
		if ((use == Use::hall || use == Use::living) && m_entrances < 2 && length > 2)
		{
			++m_entrances;
			if (m_dice.chance(0.3))
				m_hanger.freeDoor(wall, 0.85, 1.1);
			else
				m_hanger.closedDoor(wall, m_dice.between(0.85, 1.05), 2.05, Filling::leaf);
		}
		const int windows = std::max(1, static_cast<int>(length / 2.5));
		for (int i = 0; i < windows; ++i)
			if (length > 1.2 && m_dice.chance(use == Use::bath ? 0.3 : 0.65))
				m_hanger.window(wall,
				                (use == Use::hall || use == Use::living || use == Use::office) && m_dice.chance(0.3));
	}

	/** Every room of a house can be reached; some doors more. */
	void connectRooms()
	{
		std::vector<std::size_t> group(m_plan.rooms.size());
		std::iota(group.begin(), group.end(), std::size_t{0});
		std::vector<std::pair<double, BuildingWall*>> inner;
		for (BuildingWall& wall : m_plan.walls)
			if (wall.left >= 0 && wall.right >= 0 && wall.to_m - wall.from_m > 1.0)
				inner.emplace_back(m_dice.between(0, 1), &wall);
		std::sort(inner.begin(), inner.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
		for (const auto& [order, wall] : inner)
		{
			std::size_t& a = group[static_cast<std::size_t>(wall->left)];
			const std::size_t b = group[static_cast<std::size_t>(wall->right)];
			const bool joined = a == b;
			if (joined && !m_dice.chance(0.2)) continue;
			if (!joinRooms(*wall) || joined) continue;
			const std::size_t old = a;
			for (std::size_t& one : group)
				if (one == old) one = b;
		}
	}

	bool joinRooms(BuildingWall& wall)
	{
		for (const int side : {1, -1})
			if (isStairs(useAt(wall, side)))
			{
				if (isStairs(useAt(wall, -side))) return false;
				stairs(wall, side);
				return roomAt(wall, side).landing_m > 0;
			}
		const auto is = [&](Use use) { return useAt(wall, 1) == use || useAt(wall, -1) == use; };
		if (is(Use::living) && is(Use::kitchen) && m_dice.chance(0.6))
			return m_hanger.passage(wall, 1.2, 3.2, m_dice.chance(0.7));
		if (is(Use::kitchen) && m_dice.chance(0.2)) m_hanger.counter(wall);
		if (is(Use::bath) || is(Use::storage)) return m_hanger.door(wall, 0.58, 0.85);
		if (m_dice.chance(0.12)) return m_hanger.passage(wall, 0.9, 1.8, m_dice.chance(0.5));
		if (m_dice.chance(0.12)) return m_hanger.doubleDoor(wall);
		return m_hanger.door(wall, 0.72, 1.0);
	}

	Plan& m_plan;
	std::string_view m_kind;
	Dice& m_dice;
	DoorHanger m_hanger;
	int m_entrances = 0;
};
}  // namespace

void addOpenings(Plan& plan, std::string_view kind, Dice& dice)
{
	OpeningPlanner(plan, kind, dice).run();
}

void addObliqueWall(Plan& plan, std::size_t index, Dice& dice)
{
	Room& room = plan.rooms[index];
	if (room.inside.sizes().minCoeff() < 4.3) return;
	const Vector2d size = room.inside.sizes();
	const double leg_x = dice.between(2.2, std::min(3.6, 0.6 * size.x()));
	const double leg_y =
	    std::clamp(leg_x * std::tan(dice.between(30, 60) * std::numbers::pi / 180), 2.0, 0.6 * size.y());
	const int corner = dice.whole(0, 3);
	const Vector2d at((corner & 1) == 0 ? room.inside.min().x() : room.inside.max().x(),
	                  (corner & 2) == 0 ? room.inside.min().y() : room.inside.max().y());
	const Vector2d inward((corner & 1) == 0 ? 1 : -1, (corner & 2) == 0 ? 1 : -1);
	Area closet(at);
	closet.extend(Vector2d(at + Vector2d(inward.x() * (leg_x + 0.3), inward.y() * (leg_y + 0.3))));
	for (const Area& taken : room.taken)
		if (closet.intersects(taken)) return;

	Vector2d from = at + Vector2d(inward.x() * leg_x, 0), to = at + Vector2d(0, inward.y() * leg_y);
	const Vector2d along = (to - from).normalized();
	const double length = (to - from).norm(), beyond = 0.12;
	BuildingWall wall;
	from -= beyond * along;
	wall.frame = {{from, std::atan2(along.y(), along.x())}, dice.between(0.07, 0.14), plan.height_m};
	wall.length_m = length + 2 * beyond;
	wall.from_m = beyond + 0.3;
	wall.to_m = wall.length_m - beyond - 0.3;
	Opening door;
	door.id = std::string("o").append(std::to_string(index));
	door.width_m = dice.between(0.76, std::min(1.0, wall.to_m - wall.from_m));
	door.middle_m = dice.between(wall.from_m + 0.5 * door.width_m, wall.to_m - 0.5 * door.width_m);
	door.high_m = std::min(dice.between(1.96, 2.1), plan.height_m - 0.1);
	// The room is on the side away from the corner.
	const Vector2d left(-along.y(), along.x());
	door.side = left.dot(at - from) < 0 ? 1 : -1;
	door.hinge_left = dice.chance(0.5);
	if (dice.chance(0.75))
	{
		door.filling = Filling::leaf;
		door.angle_rad = dice.chance(0.35) ? 0 : dice.between(80, 92) * std::numbers::pi / 180;
	}
	for (const int side : {1, -1})
		room.taken.push_back(wall.before(door.middle_m - 0.5, door.middle_m + 0.5, side, 1.1));
	closet.extend(wall.before(0.3, wall.length_m - 0.3, door.side, 0.1).min());
	closet.extend(wall.before(0.3, wall.length_m - 0.3, door.side, 0.1).max());
	room.taken.push_back(closet);
	wall.openings.push_back(door);
	plan.walls.push_back(std::move(wall));
}
}  // namespace explore::test
