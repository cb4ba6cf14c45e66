// Walls (Algorithm 1, lines 7–10): dominant planes one after the other, those at right angles to the ground kept.
#pragma once

#include <explore/core/results.h>
#include <explore/perception/planes.h>

#include <vector>

namespace explore
{
struct WallConfig
{
	double max_tilt_rad = 0.2617993877991494;  ///< off the vertical, as the ground's 15°
};
void describe(FieldVisitor& fields, WallConfig& config);

struct WallPatch
{
	Wall wall;
	PointCloud inliers_in_robot;  ///< projected onto the plane
};

/** Extracts planes from `points` (ground already removed) until at most alpha · `filtered_count` points are left or no
 *  plane has enough inliers; returns the vertical ones, largest first as found. `camera_in_robot` is the point that
 * wall normals turn to and that floor lines start from. */
std::vector<WallPatch> findWalls(const PointCloud& points, std::size_t filtered_count, const Plane& ground,
                                 const Eigen::Vector3d& camera_in_robot, const WallConfig& config,
                                 const PlaneSearchConfig& planes, RandomEngine& random);

/** The line where two planes meet: the point nearest to `from`, by the 5×5 Lagrange system (paper eq. 3–4), and the
 *  direction n₁ × n₂. No value for parallel planes. */
std::optional<Line> intersectionLine(const Plane& wall, const Plane& ground, const Eigen::Vector3d& from);
}  // namespace explore
