// Steers a robot along a list of points: pure pursuit.
#pragma once

#include <explore/simulation/robot_motion.h>

#include <vector>

namespace explore::simulation
{
class PathFollower
{
public:
	/** At least one point, neighbours apart; z counts for a MAV only. */
	PathFollower(std::vector<Eigen::Vector3d> points_in_map, const RobotConfig& robot);

	/** What brings the robot to the path's point half a metre ahead of it: it turns on the spot first where that lies
	 *  more than 60° aside, slows down in turns and comes to rest at the end. */
	[[nodiscard]] Command steer(const RobotState& state);
	/** Within 10 cm of the last point, or past it. */
	[[nodiscard]] bool done() const { return m_done; }

private:
	[[nodiscard]] Eigen::Vector3d pointAt(double along_m) const;
	[[nodiscard]] double allowedSpeed(const RobotState& state) const;
	void followProgress(const RobotState& state);

	RobotConfig m_robot;
	std::vector<Eigen::Vector3d> m_points;
	std::vector<double> m_along_m;    ///< of each point, from the first
	std::vector<double> m_speed_mps;  ///< at each point: less where the path bends, 0 at its end
	double m_progress_m = 0;
	bool m_done = false;
};
}  // namespace explore::simulation
