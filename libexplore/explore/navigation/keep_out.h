// Where the robot is allowed to be: bounds and keep-out polygons.
#pragma once

#include <explore/navigation/plan_config.h>

#include <Eigen/Core>
#include <vector>

namespace explore
{
/** Corners in order, map frame [m]. */
using PlanPolygon = std::vector<Eigen::Vector2d>;

struct AllowedArea
{
	bool bounded = false;
	Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
	std::vector<PlanPolygon> keep_out;

	[[nodiscard]] bool inBounds(const Eigen::Vector2d& point_in_map) const;
	[[nodiscard]] bool isKeptOut(const Eigen::Vector2d& point_in_map) const;
	[[nodiscard]] bool allows(const Eigen::Vector2d& point_in_map) const
	{
		return inBounds(point_in_map) && !isKeptOut(point_in_map);
	}
};

/** Throws ConfigError for a polygon that is not numbers, or has fewer than three corners, or bounds that enclose
 * nothing. */
AllowedArea allowedArea(const BoundsConfig& config);
}  // namespace explore
