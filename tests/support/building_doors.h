// Doors of made-up buildings: what kind, how large, how far open, and where in a wall.
#pragma once

#include "support/building_plan.h"

#include <functional>
#include <optional>

namespace explore::test
{
/** What all doors of a building have in common. */
struct DoorStyle
{
	double casing_m = 0, casing_proud_m = 0, stop_m = 0, height_m = 2.0;
	double threshold_share = 0.2;
};
DoorStyle doorStyleOf(const Plan& plan, Dice& dice);

/** Hangs openings into the walls of a plan, so that no two and no leaves are in each other's way. */
class DoorHanger
{
public:
	DoorHanger(Plan& plan, Dice& dice) : m_plan(plan), m_dice(dice), m_style(doorStyleOf(plan, dice)) {}

	/** A door of any state in that wall; false where there is no place for it. */
	bool door(BuildingWall& wall, double narrow_m, double wide_m);
	/** One that stands open or has no leaf. */
	bool freeDoor(BuildingWall& wall, double narrow_m, double wide_m);
	bool closedDoor(BuildingWall& wall, double width_m, double height_m, Filling filling);
	/** 1.2–1.9 m with two leaves. */
	bool doubleDoor(BuildingWall& wall);
	/** Without a leaf; up to the ceiling where `lintel` is false. `full` = from corner to corner. */
	bool passage(BuildingWall& wall, double narrow_m, double wide_m, bool lintel, bool full = false);
	bool window(BuildingWall& wall, bool to_floor);
	bool niche(BuildingWall& wall);
	bool counter(BuildingWall& wall);
	/** To stairs downward that begin right behind it. */
	bool dropDoor(BuildingWall& wall, int stairs_side);

private:
	/** Near what the robots need (0.54 m and 0.70 m): whether they fit would be a matter of millimetres. */
	[[nodiscard]] static bool doubtful(double clear_m);
	[[nodiscard]] Opening basic(double width_m);
	void chooseState(Opening& opening, const BuildingWall& wall);
	void hangLeaf(Opening& opening, const BuildingWall& wall);
	void chooseSliding(Opening& opening, const BuildingWall& wall);
	[[nodiscard]] std::optional<double> freeMiddle(const BuildingWall& wall, double width_m, bool corner);
	/** From its jambs to the walls across on the leaf's side, and so where there is place for casings. */
	void measureCorners(const BuildingWall& wall, Opening& opening) const;
	[[nodiscard]] bool fits(const BuildingWall& wall, const Opening& whole) const;
	/** Tries until place and state fit. */
	bool hang(BuildingWall& wall, const std::function<Opening()>& make);
	void take(BuildingWall& wall, Opening opening);

	Plan& m_plan;
	Dice& m_dice;
	DoorStyle m_style;
	int m_doors = 0;
};
}  // namespace explore::test
