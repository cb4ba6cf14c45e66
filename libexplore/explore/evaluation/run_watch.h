// Watches a simulated run frame by frame: how far the robot really went, and whether its goals flipped.
#pragma once

#include <explore/core/results.h>
#include <mrpt/poses/CPose3D.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace explore::evaluation
{
struct WatchedFrame
{
	double t_s = 0;
	mrpt::poses::CPose3D map_from_robot;  ///< the true one
	GoalKind goal = GoalKind::none;
	std::optional<Eigen::Vector3d> goal_in_map;
	bool goal_lost = false;  ///< what the map newly shows has put an end to the goal of the frame before
};

/** Goals are places: another one begins where the goal is 0.5 m or more from where it was in the frame before. A frame
 *  without a place, or one of `recover`, leaves the goal as it was. */
class RunWatch
{
public:
	/** By time. */
	void add(const WatchedFrame& frame);

	/** Length of the true path. */
	[[nodiscard]] double path_m() const { return m_path_m; }
	/** True distance from the first frame's place on the floor plan. */
	[[nodiscard]] double fromStart_m() const;
	/** Returns to within 0.5 m of a goal that was left less than 20 s before, while the one in between was neither
	 *  reached (the robot within 0.5 m of it on the floor plan) nor lost (doc/definitions.md, "Goal flip"). */
	[[nodiscard]] std::size_t flips() const { return m_flips; }

	/** Writes or reads all of it. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_start_in_map), archive(m_robot_in_map), archive(m_path_m), archive(m_goal_in_map);
		archive(m_goal_done), archive(m_left), archive(m_flips);
	}

private:
	struct Left
	{
		double t_s = 0;
		Eigen::Vector3d place_in_map = Eigen::Vector3d::Zero();
	};
	void follow(const WatchedFrame& frame);
	void change(const WatchedFrame& frame);
	[[nodiscard]] bool nearGoal() const;

	std::optional<Eigen::Vector3d> m_start_in_map;
	Eigen::Vector3d m_robot_in_map = Eigen::Vector3d::Zero();
	double m_path_m = 0;
	std::optional<Eigen::Vector3d> m_goal_in_map;
	bool m_goal_done = false;  ///< reached or lost
	std::vector<Left> m_left;  ///< goals before the present one, of the last 20 s
	std::size_t m_flips = 0;
};
}  // namespace explore::evaluation
