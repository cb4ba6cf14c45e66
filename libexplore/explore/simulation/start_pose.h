// Where a robot begins in a simulated world, in the words of a person.
#pragma once

#include <explore/core/robot.h>
#include <explore/simulation/world.h>
#include <mrpt/poses/CPose3D.h>

#include <string>

namespace explore::simulation
{
/** map_from_robot of `start`: the name of a spawn, or "x y yaw" or "x y z yaw" (m, degrees); without z it is on the
 * floor there. Empty stands for the first spawn at a height that suits the robot, else the first one, else the origin.
 * A MAV that would start below its flight band starts in the middle of it. Throws ConfigError, which lists the world's
 * spawns. */
mrpt::poses::CPose3D startPose(const World& world, const std::string& start, const RobotConfig& robot);
}  // namespace explore::simulation
