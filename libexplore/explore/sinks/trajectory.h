// trajectory.tum: the path of the robot, as evo and the TUM tools read it.
#pragma once

#include <explore/core/depth_frame.h>

#include <string>

namespace explore
{
/** map_from_robot of `frame` as `t x y z qx qy qz qw` (s, m, unit quaternion with qw ≥ 0), ended by a newline. */
std::string trajectoryLine(const DepthFrame& frame);
}  // namespace explore
