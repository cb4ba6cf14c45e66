// The errors of a structured-light camera by the formulas of Nguyen, Izadi and Lovell (2012).
#pragma once

#include <explore/simulation/sensor_view.h>

namespace explore::simulation
{
/** The depth image that the camera delivers of `view`; 0 where it has no return. Each pixel looks a little beside its
 *  line of sight, its depth gets axial noise and is rounded to a step of disparity. Nguyen's sigma is what users of a
 *  real device see, rounding included: the noise added is what the rounding leaves of it. */
std::vector<float> kinectDepth(const SensorView& view, const DepthCameraConfig& config, std::uint64_t seed);
}  // namespace explore::simulation
