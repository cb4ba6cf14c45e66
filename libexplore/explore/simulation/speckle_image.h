// The infrared picture of a projected speckle pattern.
#pragma once

#include <explore/simulation/sensor_view.h>

namespace explore::simulation
{
/** Counts of the camera's converter, row-major. What a surface returns falls with the square of its distance, with its
 *  incidence and its reflectance; noise and saturation are those of a small image sensor. Where `view` has no return
 *  there is only ambient light. */
std::vector<std::uint16_t> infraredImage(const SensorView& view, const DepthCameraConfig& config, std::uint64_t seed);
}  // namespace explore::simulation
