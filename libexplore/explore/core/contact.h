// Where a simulated robot bumped into something.
#pragma once

#include <Eigen/Core>

namespace explore
{
/** One touch of the robot's body with something while it moved. */
struct Contact
{
	double t_s = 0;                                             ///< since the first frame
	Eigen::Vector3d position_in_map = Eigen::Vector3d::Zero();  ///< of the robot
};
}  // namespace explore
