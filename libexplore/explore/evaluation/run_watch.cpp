#include <explore/evaluation/run_watch.h>

#include <algorithm>

namespace explore::evaluation
{
namespace
{
constexpr double kSamePlace_m = 0.5, kMemory_s = 20.0;
}

void RunWatch::add(const WatchedFrame& frame)
{
	const auto& pose = frame.map_from_robot;
	const Eigen::Vector3d place_in_map(pose.x(), pose.y(), pose.z());
	if (m_start_in_map)
		m_path_m += (place_in_map - m_robot_in_map).norm();
	else
		m_start_in_map = place_in_map;
	m_robot_in_map = place_in_map;
	follow(frame);
}

double RunWatch::fromStart_m() const
{
	return m_start_in_map ? (m_robot_in_map - *m_start_in_map).head<2>().norm() : 0.0;
}

void RunWatch::follow(const WatchedFrame& frame)
{
	m_goal_done = m_goal_done || frame.goal_lost || nearGoal();
	if (frame.goal_in_map && frame.goal != GoalKind::recover)
	{
		if (m_goal_in_map && (*frame.goal_in_map - *m_goal_in_map).norm() >= kSamePlace_m) change(frame);
		m_goal_in_map = frame.goal_in_map;
	}
	m_goal_done = m_goal_done || nearGoal();
}

bool RunWatch::nearGoal() const
{
	return m_goal_in_map && (m_robot_in_map - *m_goal_in_map).head<2>().norm() < kSamePlace_m;
}

void RunWatch::change(const WatchedFrame& frame)
{
	std::erase_if(m_left, [&](const Left& left) { return frame.t_s - left.t_s >= kMemory_s; });
	const auto is_back = [&](const Left& left)
	{ return (left.place_in_map - *frame.goal_in_map).norm() < kSamePlace_m; };
	if (!m_goal_done && std::any_of(m_left.begin(), m_left.end(), is_back)) ++m_flips;
	m_left.push_back({frame.t_s, *m_goal_in_map});
	m_goal_done = false;
}
}  // namespace explore::evaluation
