#include "support/building_doors.h"
#include "support/building_leaves.h"

#include <explore/core/geometry.h>

#include <algorithm>

namespace explore::test
{
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
}  // namespace explore::test
