// The solid that stands for a robot in the simulator: what must not touch anything.
#pragma once

#include <explore/core/robot.h>
#include <explore/simulation/ray_scene.h>
#include <explore/simulation/triangle_distance.h>

namespace explore::simulation
{
/** A ground robot's body begins this far above the floor: what is lower is rolled over. */
inline constexpr double kUnderbody_m = 0.03;

/** The upright body of a robot whose origin is at `position_in_map`: on the floor for a ground robot, in the middle of
 *  the body for a MAV. Roll and pitch are left out: the radius holds the whole body at any tilt. */
VerticalCylinder bodyAt(const RobotConfig& robot, const Eigen::Vector3d& position_in_map);

/** The same, larger by `margin_m` to all sides, a ground robot's not downward: the floor is always that near. */
VerticalCylinder bodyWithMargin(const RobotConfig& robot, const Eigen::Vector3d& position_in_map, double margin_m);

/** How far [m] bodyAt() may grow (see bodyWithMargin) before it touches anything, to 1 mm, but at most `max_m`. Near
 * the cylinder's rims it is up to a third less than the distance there. */
double bodyClearance(const RayScene& scene, const RobotConfig& robot, const Eigen::Vector3d& position_in_map,
                     double max_m);
}  // namespace explore::simulation
