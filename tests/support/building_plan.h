// The floor plan of a made-up building: rectangular rooms, the walls between them and the openings in those.
#pragma once

#include "support/building_opening.h"

#include <Eigen/Geometry>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace explore::test
{
using Area = Eigen::AlignedBox2d;

enum class Use
{
	living,
	bedroom,
	kitchen,
	bath,
	office,
	meeting,
	classroom,
	corridor,
	vestibule,
	hall,
	storage,
	guest,
	stairs_down,
	stairs_up,
	warehouse
};

struct Room
{
	Use use = Use::living;
	Area axes;                 ///< between the axes of its walls
	Area inside;               ///< between their faces
	std::vector<Area> taken;   ///< ways to doors, leaves, furniture
	std::vector<Area> leaves;  ///< where leaves stand
	double landing_m = 0;      ///< stairs: floor between door and first step
	int way_down = 0;          ///< stairs: side at which the door is: 0 west, 1 east, 2 south, 3 north
};

struct BuildingWall
{
	WallFrame frame;  ///< from axis to axis of the walls that it ends at
	double length_m = 0;
	double from_m = 0, to_m = 0;  ///< what is free of those walls
	int left = -1, right = -1;    ///< rooms; −1 = outdoors
	std::vector<Opening> openings;

	/** The area before its left (1) or right (−1) face. */
	[[nodiscard]] Area before(double from, double to, int side, double depth_m) const;
	[[nodiscard]] int roomAt(int side) const { return side > 0 ? left : right; }
};

struct Plan
{
	double height_m = 2.6;
	double outer_m = 0.3, inner_m = 0.12, corridor_m = 0.15;  ///< thickness
	std::vector<Room> rooms;
	std::vector<BuildingWall> walls;
};

/** Rooms of a building of that kind (house, office, school, warehouse, hotel). */
Plan planOf(std::string_view kind, Dice& dice);
/** The walls between its rooms and around them; sets the rooms' insides. */
void raiseWalls(Plan& plan, Dice& dice);
/** Doors, passages, windows, niches. */
void addOpenings(Plan& plan, std::string_view kind, Dice& dice);
/** A wall across a corner of the room, with a door; not everywhere is place for one. */
void addObliqueWall(Plan& plan, std::size_t room, Dice& dice);
/** Walls, floors, ceilings, stairs, skirting, posts. */
void buildShell(Sketch& sketch, const Plan& plan, Dice& dice);
}  // namespace explore::test
