// What each vertical strip of the image saw near the robot, and where the sensor measured nothing.
#pragma once

#include <explore/config/fields.h>
#include <explore/core/depth_frame.h>
#include <explore/core/results.h>

#include <optional>

namespace explore
{
struct NearFieldConfig
{
	double sensor_min_range_m = 0.5;  ///< the sensor measures nothing nearer than this
};
void describe(FieldVisitor& fields, NearFieldConfig& config);

/** Strips of equal width from left to right. `nearest_m` counts what stands more than 0.1 m above the ground, where a
 *  ground is known, so that the floor in front of the robot is no obstacle. */
NearField nearField(const DepthFrame& frame, const std::optional<Plane>& ground);

/** Where something may stand that is too near to be measured: points just within the minimum range, robot frame, at the
 *  sensor's height, on every strip of `now` in which nothing at all returned, the floor neither. None when that holds
 * for most of the image: it is dark, then, or the lens is covered. */
PointCloud hiddenNear(const DepthFrame& frame, const NearField& now, const NearFieldConfig& config);
}  // namespace explore
