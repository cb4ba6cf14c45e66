// Where in a world a robot can get to, known from the world itself.
#pragma once

#include <explore/core/robot.h>
#include <explore/core/truth.h>
#include <explore/simulation/world.h>

#include <Eigen/Core>
#include <functional>

namespace explore::simulation
{
/** The 5 cm cells in whose middle the robot's body fits with 5 cm to spare around it (a MAV also above and below), and
 *  that are connected to the start over such cells with shared sides (doc/definitions.md, "Reachable").
 *
 *  - A ground robot stays on the start's height and needs floor below its middle and its rim, where there is floor at
 *    the start. Its level is what has to be free above the floor: from 0.10 m to its height.
 *  - A MAV has a level every 5 cm of its flight band, whose heights count from what is below its start.
 *  - What moves is left out. Doors are as they stand.
 *  - The box around what is solid in the world (solidBounds) ends it.
 *  - Cells whose middle `allows` (on the floor plan) says no to are not reachable, nor is what lies behind them;
 * without `allows` the robot may be anywhere.
 *  - Where the start's own cell is too tight the nearest one within 0.3 m counts; without one nothing is reachable. */
TruthReach reachableSpace(const World& world, const RobotConfig& robot, const Eigen::Vector3d& start_in_map,
                          const std::function<bool(const Eigen::Vector2d& point_in_map)>& allows = {});
}  // namespace explore::simulation
