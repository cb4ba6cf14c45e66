// From a depth frame to points within range, robot frame (Algorithm 1, line 2).
#pragma once

#include <explore/config/fields.h>
#include <explore/core/depth_frame.h>
#include <explore/core/geometry.h>

#include <functional>

namespace explore
{
struct RangeFilterConfig
{
	double max_range_m = 5.0;  ///< paper: 5 m, 8 m for simulated warehouses
};
void describe(FieldVisitor& fields, RangeFilterConfig& config);

/** The measurements with 0 < range ≤ max_range as points in the robot frame, in pixel order. Range is the depth along
 * the optical axis for images (as the paper's filter along Z) and the distance from the sensor for unorganised clouds,
 * which may look all around. Near measurements stay: they are obstacles. */
PointCloud rangeFilter(const DepthFrame& frame, const RangeFilterConfig& config);

/** The same points piece by piece (image row by image row), for a taker that does not need them all at once. */
void rangeFilter(const DepthFrame& frame, const RangeFilterConfig& config,
                 const std::function<void(const PointBlock&)>& take);

/** A box in the robot frame that holds whatever rangeFilter() can deliver. */
Eigen::AlignedBox3f reachOf(const DepthFrame& frame, const RangeFilterConfig& config);
}  // namespace explore
