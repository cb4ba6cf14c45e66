// The view from above: upright surfaces as a scan of points, each the mean of the samples that one direction has there.
#pragma once

#include <explore/perception/level_view.h>
#include <explore/perception/sensor_noise.h>

#include <cstddef>
#include <vector>

namespace explore
{
struct PlanScanConfig
{
	double max_range_m = 5.0;
	double min_height_m = 0.3;  ///< nothing that ends below this height makes points
};

/** Points of the plan view, level frame, sorted by direction, nearer ones last; all arrays have the same length. A
 *  plane is a line in (slope, inverse): inverse = −(n_x + n_y · slope) / offset, and there the noise of a
 *  structured-light camera is nearly the same everywhere. */
struct PlanScan
{
	double bin_width = 0;        ///< of `slope`
	std::vector<int> bin;        ///< direction, counted from the right
	std::vector<float> slope;    ///< y / x
	std::vector<float> inverse;  ///< 1 / x
	std::vector<float> x, y;
	std::vector<float> noise;    ///< σ_z / depth: times the plane's distance it is the noise across the plane [m]
	std::vector<float> samples;  ///< that make the point
	std::vector<float> bottom_m, top_m;

	[[nodiscard]] std::size_t size() const { return x.size(); }
};

/** Horizontal surfaces spread over many distances and make no points, nor do things lower than a hand's breadth. */
PlanScan planScan(const LevelView& view, const PlanScanConfig& config, const SensorNoiseConfig& noise);
}  // namespace explore
