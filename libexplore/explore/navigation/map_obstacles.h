// What the map knows around the robot, as obstacle points for the avoider: it remembers what is out of view.
#pragma once

#include <explore/core/point_cloud.h>
#include <explore/memory/body_layers.h>

#include <Eigen/Geometry>

namespace explore
{
/** The middles of the cells within `range_m` of the robot that its body must not enter, in its layer: occupied ones,
 *  drops, and unknown ones beside free ones, but for those that it touches where it stands; robot frame, at mid height
 *  of a ground robot's body or at the MAV's. Without `unknown_blocks` no unknown ones. */
PointCloud mapObstacles(const BodyLayers& layers, const Eigen::Isometry3d& map_from_robot, const RobotConfig& robot,
                        double range_m, bool unknown_blocks = true);
}  // namespace explore
