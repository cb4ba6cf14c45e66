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

/** The level frame over `ground` (robot frame, normal up). Without a floor `up_in_robot` (unit) tells what is level,
 * and the altitude is 0. */
LevelFrame levelFrame(const std::optional<Plane>& ground,
                      const Eigen::Vector3d& up_in_robot = Eigen::Vector3d::UnitZ());
}  // namespace explore
