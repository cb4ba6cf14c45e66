// What a robot that follows a way goes toward.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace explore
{
struct Aim
{
	Eigen::Vector3d point_in_map;
	double rest_m;  ///< to the way's end
};

/** The point `ahead_m` further on the way than where the robot is, or the way's end. */
Aim aimOn(const std::vector<Eigen::Vector3d>& way, const Eigen::Vector3d& at, double ahead_m);
}  // namespace explore
