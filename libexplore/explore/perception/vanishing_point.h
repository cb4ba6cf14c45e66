// Vanishing points from wall–floor lines (paper §3.1, "Vanishing Point Estimation").
#pragma once

#include <explore/core/results.h>
#include <explore/perception/walls.h>

#include <vector>

namespace explore
{
struct VanishingPointConfig
{
	double parallel_rad = 0.17453292519943295;  ///< lines within 10° lead to the same point
};
void describe(FieldVisitor& fields, VanishingPointConfig& config);

/** One point a group of parallel wall–floor lines: the furthest point, among the walls' inliers, on the line through
 *  `camera_in_robot` that runs parallel to them (inlier-weighted mean direction), on the side the robot looks to. Most
 *  inliers first. */
std::vector<VanishingPoint> findVanishingPoints(const std::vector<WallPatch>& walls, const Plane& ground,
                                                const Eigen::Vector3d& camera_in_robot,
                                                const VanishingPointConfig& config);
}  // namespace explore
