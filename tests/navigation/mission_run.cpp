#include "navigation/mission_run.h"

#include <algorithm>
#include <cmath>

namespace explore::test
{
namespace
{
constexpr double kTick_s = 0.5, kRange_m = 4.0, kHalfView_rad = 0.49;

DrawnMap nothingOf(DrawnMap world)
{
	for (int row = 0; row < world.rows(); ++row)
		for (int column = 0; column < world.columns(); ++column) world.set(column, row, '?');
	return world;
}
}  // namespace

MissionRun::MissionRun(const DrawnMap& world, const MissionConfig& config)
    : m_world(world),
      m_known(nothingOf(world)),
      m_config(config),
      m_memory({}, m_robot),
      m_start(world.at('r')),
      m_at(m_start)
{
}

void MissionRun::look()
{
	const DrawnMap before = m_known;
	constexpr int kRays = 115;
	for (int i = 0; i < kRays; ++i)
	{
		const double azimuth_rad = m_yaw_rad + kHalfView_rad * (2.0 * i / (kRays - 1) - 1.0);
		const Eigen::Vector2d ray(std::cos(azimuth_rad), std::sin(azimuth_rad));
		for (double away_m = 0.0; away_m < kRange_m; away_m += 0.03)
		{
			const Eigen::Vector2d point = m_at.head<2>() + away_m * ray;
			const char there = m_world.on(point);
			if (there == '~' || there == '?') break;
			m_known.show(point, there);
			if (there == '#') break;
		}
	}
	m_memory.layers.stood(m_at);
	test::change(m_memory, before, m_known, m_robot);
}

void MissionRun::advance(double way_m)
{
	const std::vector<Eigen::Vector3d> way = m_mission.way_in_map;
	for (std::size_t i = 1; i < way.size() && way_m > 0.0; ++i)
	{
		const Eigen::Vector3d step = way[i] - m_at;
		const double length_m = step.head<2>().norm();
		if (length_m < 1e-6) continue;
		const double walked_m = std::min(way_m, length_m);
		m_yaw_rad = std::atan2(step.y(), step.x());
		m_at.head<2>() += step.head<2>() * (walked_m / length_m);
		m_path_m += walked_m;
		way_m -= walked_m;
		if (walked_m < length_m) return;
	}
	m_yaw_rad = m_mission.goal->yaw_rad;
}

void MissionRun::move()
{
	if (!m_mission.goal) return;
	advance(m_robot.max_speed_mps * kTick_s);
	// What lies behind the robot on its way is done with.
	std::vector<Eigen::Vector3d>& way = m_mission.way_in_map;
	while (way.size() > 1 && (way[1] - m_at).head<2>().norm() < 1e-6) way.erase(way.begin());
	for (int row = 0; row < m_world.rows(); ++row)
		for (int column = 0; column < m_world.columns(); ++column)
			if (m_world.character(column, row) == '#')
				m_clearance_m = std::min(m_clearance_m, m_world.distanceTo(column, row, m_at));
}

void MissionRun::noteGoal()
{
	if (!m_mission.goal) return;
	const Eigen::Vector3d goal = m_mission.goal->stand_in_map;
	const auto same = [&](const Eigen::Vector3d& other) { return (other - goal).norm() < 0.3; };
	if (!m_goals.empty() && same(m_goals.back())) return;
	// Back to the one before the last, in two ticks.
	if (m_goals.size() > 1 && same(m_goals[m_goals.size() - 2]) && !m_mission.goal_lost) ++m_flips;
	m_goals.push_back(goal);
}

void MissionRun::tick()
{
	look();
	MissionNow now;
	now.map_from_robot.translate(m_at).rotate(Eigen::AngleAxisd(m_yaw_rad, Eigen::Vector3d::UnitZ()));
	now.t_s = m_t_s;
	pursue(m_mission, m_memory, now, m_robot, m_config);
	noteGoal();
	if (!done()) move();
	m_t_s += kTick_s;
}

void MissionRun::run(double seconds)
{
	for (const double until_s = m_t_s + seconds; m_t_s < until_s && !done();) tick();
}

std::size_t MissionRun::freeButUnknown() const
{
	std::size_t count = 0;
	for (int row = 0; row < m_world.rows(); ++row)
		for (int column = 0; column < m_world.columns(); ++column)
		{
			const char there = m_world.character(column, row);
			const bool free = there != '#' && there != '?' && there != '~';
			count += free && m_known.character(column, row) == '?' ? 1 : 0;
		}
	return count;
}
}  // namespace explore::test
