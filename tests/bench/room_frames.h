// The frames of simulated rooms that the benchmarks run on: furnished scenes of every family, as a Kinect sees them.
#pragma once

#include <explore/core/depth_frame.h>

#include <vector>

namespace explore::test
{
/** VGA frames with a Kinect's noise: one scene of each family, two looks at each 0.2–0.5 s apart, scenes 20 s apart. A
 *  ground robot's poses and gravity are those of its odometry and IMU without their errors. */
std::vector<DepthFrame> roomFrames();
}  // namespace explore::test
