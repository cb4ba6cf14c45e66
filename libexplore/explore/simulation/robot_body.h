// The solid that stands for a robot in the simulator: what must not touch anything.
#pragma once

#include <explore/core/robot.h>
#include <explore/simulation/triangle_distance.h>

namespace explore::simulation
{
/** A ground robot's body begins this far above the floor: what is lower is rolled over. */
inline constexpr double kUnderbody_m = 0.03;

/** The upright body of a robot whose origin is at `position_in_map`: on the floor for a ground robot, in the middle of
 *  the body for a MAV. Roll and pitch are left out: the radius holds the whole body at any tilt. */
VerticalCylinder bodyAt(const RobotConfig& robot, const Eigen::Vector3d& position_in_map);
}  // namespace explore::simulation
