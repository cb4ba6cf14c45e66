// The floor in the camera frame: near points first, then as far as it goes, weighted by the sensor's noise.
#pragma once

#include <explore/perception/sensor_noise.h>
#include <explore/perception/up_prior.h>

namespace explore
{
struct FloorConfig
{
	double height_tolerance_m = 0.15;  ///< a known camera height is off by at most this much
	int min_samples = 60;              ///< of the grid of 160 × 120
	double dominant_share = 0.2;  ///< a lower surface is the floor when it has this share of the largest one's samples
};
void describe(FieldVisitor& fields, FloorConfig& config);

/** How high the camera can be above the floor before one is seen. */
struct CameraHeight
{
	std::optional<double> expected_m;  ///< from the mount or an earlier floor
	double tolerance_m = 0;            ///< of the expected one
	double min_m = 0.1, max_m = 3.0;   ///< where nothing is expected
};

struct Floor
{
	Plane plane_in_camera;  ///< normal up; d_m is the camera's height
	std::size_t samples = 0;
	double tilt_sigma_rad = 0, height_sigma_m = 0;
};

/** The horizontal surface that the robot is over: the best supported one at the expected height; else the lowest
 *  dominant one. A surface elsewhere than expected is taken only where it is large and nothing is seen below it. */
std::optional<Floor> findFloor(const SampleGrid& grid, const UpPrior& up_in_camera, const CameraHeight& height,
                               const FloorConfig& config, const SensorNoiseConfig& noise);
}  // namespace explore
