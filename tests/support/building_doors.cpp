#include "support/building_doors.h"

#include <explore/core/geometry.h>

#include <algorithm>

namespace explore::test
{
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
