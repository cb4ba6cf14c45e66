// The planner's map in larger cells: for the costs of many ways at once.
#pragma once

#include <explore/core/robot.h>
#include <explore/navigation/plan_map.h>

namespace explore
{
/** How many cells of the map a larger one may be wide: so few that no two that lie side by side reach to both sides of
 *  what the robot does not fit through. At least 1. */
int coarseness(const PlanMap& map, const RobotConfig& robot, const PlanConfig& config);

/** Squares of `factor` × `factor` cells of each layer, aligned with its cell (0, 0). A square is passable where any of
 * its cells is, and then as far from obstacles as the farthest passable one; blocked where all that are passable are.
 * What is wanted is left out. */
PlanMap coarsened(const PlanMap& map, int factor);
/** The square that holds the cell; kNoCell for kNoCell. */
CellIndex squareOf(const PlanMap& map, const PlanMap& coarse, CellIndex cell, int factor);
}  // namespace explore
