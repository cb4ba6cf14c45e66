// The robot frame turned level by the floor: where heights, altitudes and headings are measured.
#pragma once

#include <explore/core/geometry.h>

#include <optional>

namespace explore
{
/** Origin of the robot frame, z along the floor's normal, x the robot's x axis laid into the floor's plane. */
struct LevelFrame
{
	Eigen::Matrix3d level_from_robot = Eigen::Matrix3d::Identity();  ///< rotation; the origins coincide
	double altitude_m = 0;                                           ///< of the origin above the floor
};

/** The level frame over `ground` (robot frame, normal up). Without a floor the robot frame counts as level and its
 *  altitude as 0. */
LevelFrame levelFrame(const std::optional<Plane>& ground);
}  // namespace explore
