// How the simulated robots move in free space: their state, and one small step of it.
#pragma once

#include <explore/config/simulated_robot.h>
#include <explore/core/results.h>
#include <explore/core/robot.h>
#include <mrpt/poses/CPose3D.h>

namespace explore::simulation
{
struct RobotState
{
	double t_s = 0;
	Eigen::Vector3d position_in_map = Eigen::Vector3d::Zero();
	Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();       ///< along the map's axes
	Eigen::Vector3d acceleration_mps2 = Eigen::Vector3d::Zero();  ///< along the map's axes
	double yaw_rad = 0, yaw_rate_radps = 0;
	double pitch_rad = 0, roll_rad = 0;  ///< 0 for a ground robot

	[[nodiscard]] mrpt::poses::CPose3D mapFromRobot() const
	{
		return {position_in_map.x(), position_in_map.y(), position_in_map.z(), yaw_rad, pitch_rad, roll_rad};
	}
};

struct MotionLimits
{
	RobotConfig robot;
	double max_yaw_acceleration_radps2 = 3.5, max_tilt_rad = 0.17;
};

/** The state `dt_s` (a few hundredths of a second) later.
 *
 *  A ground robot has two driven wheels: it follows command.velocity_mps.x() forward or back and the yaw rate, each as
 *  fast as the limits let it, and keeps its height. A MAV follows the velocity in its level frame (yaw only, no tilt):
 *  it leans by at most max_tilt_rad, with a lag of 0.15 s, and its horizontal acceleration is what the lean gives. */
RobotState moved(const RobotState& state, const Command& command, const MotionLimits& limits, double dt_s);

/** Standard gravity [m/s²]. */
inline constexpr double kGravity_mps2 = 9.80665;
}  // namespace explore::simulation
