// Dominant planes by RANSAC (Fischler & Bolles 1981; paper §3.1 "Plane Extraction").
#pragma once

#include <explore/config/fields.h>
#include <explore/core/geometry.h>
#include <explore/core/point_cloud.h>

#include <cstdint>
#include <optional>
#include <random>
#include <vector>

namespace explore
{
struct PlaneSearchConfig
{
	double tolerance_m = 0.05;  ///< inlier distance
	double alpha = 0.2;         ///< stop when this share of the filtered points is left (Algorithm 1)
	int min_inliers = 60;       ///< voxels; a smaller plane is not worth a wall
	int max_iterations = 400;   ///< RANSAC hypotheses per plane
};
void describe(FieldVisitor& fields, PlaneSearchConfig& config);

/** Which planes a search accepts: those whose normal lies within `max_angle_rad` of `axis`, signs ignored. */
struct NormalCone
{
	Eigen::Vector3d axis;
	double max_angle_rad;
};

struct FoundPlane
{
	Plane plane;                         ///< least-squares fit to its inliers
	std::vector<std::uint32_t> inliers;  ///< indices into the searched cloud, ascending
};

using RandomEngine = std::mt19937;

/** The plane with the most points within tolerance, refined by least squares; no value when none has min_inliers. With
 *  `cone`, the plane with the most contrast is taken among those drawn inside it (refinement may lead out of it again).
 *  Deterministic given the engine's state. */
std::optional<FoundPlane> dominantPlane(const PointCloud& points, const PlaneSearchConfig& config, RandomEngine& random,
                                        const std::optional<NormalCone>& cone = std::nullopt);

/** Indices of the points within `tolerance_m` of the plane, ascending. */
std::vector<std::uint32_t> inliersOf(const PointCloud& points, const Plane& plane, double tolerance_m);

/** Points within tolerance, less those in the layer of the same thickness just above or below, whichever has more. A
 * slice through things that stand across the plane has as many points outside as inside: its contrast is near 0. */
int contrast(const PointCloud& points, const Plane& plane, double tolerance_m);

/** Total-least-squares plane through the given points (smallest principal axis of their covariance). */
Plane fitPlane(const PointCloud& points, const std::vector<std::uint32_t>& indices);

/** Copies of the given points, moved along the normal onto the plane (Algorithm 1, "project nearby points onto plane").
 */
PointCloud projectOnto(const Plane& plane, const PointCloud& points, const std::vector<std::uint32_t>& indices);

/** The points whose index is not in `indices` (ascending), in order. */
PointCloud without(const PointCloud& points, const std::vector<std::uint32_t>& indices);
}  // namespace explore
