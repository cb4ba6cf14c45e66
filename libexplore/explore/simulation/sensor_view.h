// What stands before each pixel of a depth camera, before the sensor adds its errors.
#pragma once

#include <explore/simulation/depth_camera.h>

namespace explore::simulation
{
/** Row-major images. */
struct SensorView
{
	std::vector<float> depth_m;      ///< along the optical axis; 0 = nothing within reach
	std::vector<float> cosine;       ///< of the incidence angle, 0–1
	std::vector<float> reflectance;  ///< 0–1: brightness of the surface; empty unless config.noise is speckle
	std::vector<std::uint8_t> lost;  ///< 1 = gives no return: black, swallowed by a pane, in the projector's shadow
	std::vector<std::uint8_t> rgb;   ///< 3 bytes a pixel; empty without color
};

/** Depths up to a little beyond the camera's range. Which pixels a pane swallows depends on `seed`. The projector's
 *  shadow is that of config.baseline_m; `with_shadow` = false leaves it out. */
SensorView lookAround(const RayScene& scene, const DepthCameraConfig& config, const Eigen::Isometry3d& map_from_camera,
                      std::uint64_t seed, bool with_shadow);
}  // namespace explore::simulation
