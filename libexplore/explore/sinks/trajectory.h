// trajectory.tum and truth.tum: the path of the robot, as evo and the TUM tools read it.
#pragma once

#include <explore/core/depth_frame.h>

#include <string>

namespace explore
{
/** `t x y z qx qy qz qw` (s, m, unit quaternion with qw ≥ 0), ended by a newline. */
std::string trajectoryLine(mrpt::Clock::time_point time, const mrpt::poses::CPose3D& map_from_robot);
/** The same with the time and the map_from_robot of `frame`. */
std::string trajectoryLine(const DepthFrame& frame);
}  // namespace explore
