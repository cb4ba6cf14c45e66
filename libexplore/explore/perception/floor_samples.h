// Samples that may belong to a floor: those that face up below the camera, and the heights at which they gather.
#pragma once

#include <explore/perception/sample_grid.h>

#include <Eigen/Core>
#include <vector>

namespace explore
{
/** A sample at depth · (1, ray_y, ray_z), `below_m` under the camera along the up that was asked for. */
struct FloorSample
{
	float depth_m, ray_y, ray_z, below_m;
};

/** The samples more than 8 cm below the camera whose surface faces up within `max_tilt_rad`. */
std::vector<FloorSample> levelSamples(const SampleGrid& grid, const Eigen::Vector3d& up_in_camera, double max_tilt_rad);

/** A height below the camera where level samples gather. */
struct HeightPeak
{
	double below_m = 0;
	double support = 0;  ///< samples; those that the tilt's uncertainty smears count less
};

/** Local maxima with at least `min_support`, lowest first. */
std::vector<HeightPeak> heightPeaks(const std::vector<FloorSample>& samples, double tilt_sigma_rad, double min_support);
}  // namespace explore
