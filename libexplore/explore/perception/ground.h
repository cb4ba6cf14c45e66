// The ground plane (Algorithm 1, line 5): near-horizontal, dominant, the lowest where there are several.
#pragma once

#include <explore/perception/planes.h>

#include <optional>

namespace explore
{
struct GroundConfig
{
	double max_tilt_rad = 0.2617993877991494;  ///< 15°, paper §3.1
};
void describe(FieldVisitor& fields, GroundConfig& config);

/** What is known before the first point is looked at, in the frame of the cloud. */
struct GroundPrior
{
	Eigen::Vector3d up = Eigen::Vector3d::UnitZ();     ///< unit, against gravity
	Eigen::Vector3d camera = Eigen::Vector3d::Zero();  ///< its centre; the ground lies below it
};

/** The lowest plane within max_tilt of `up` and below the camera that has enough inliers and does not just cut through
 *  things that stand (see contrast()); normal turned up. No value when there is none. */
std::optional<FoundPlane> findGround(const PointCloud& points, const GroundPrior& prior, const GroundConfig& config,
                                     const PlaneSearchConfig& planes, RandomEngine& random);
}  // namespace explore
