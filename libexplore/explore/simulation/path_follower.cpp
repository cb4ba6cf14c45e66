#include <explore/core/geometry.h>
#include <explore/simulation/path_follower.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore::simulation
{
namespace
{
constexpr double kLookAhead_m = 0.5, kNearEnough_m = 0.1, kProgressStep_m = 0.01;
constexpr double kTurnOnTheSpot_rad = std::numbers::pi / 3;
constexpr double kYawGain_per_s = 2.0;
/** Of its acceleration: what remains is for the lag of its drive. */
constexpr double kBrakingShare = 0.5;
constexpr double kSlowest_mps = 0.05;
}  // namespace

PathFollower::PathFollower(std::vector<Eigen::Vector3d> points_in_map, const RobotConfig& robot)
    : m_robot(robot), m_points(std::move(points_in_map)), m_along_m{0.0}
{
	for (std::size_t i = 1; i < m_points.size(); ++i)
	{
		if (robot.kind == RobotKind::ground) m_points[i].z() = m_points.front().z();
		m_along_m.push_back(m_along_m.back() + (m_points[i] - m_points[i - 1]).norm());
	}
	m_speed_mps.assign(m_points.size(), 0.0);
	for (std::size_t i = 1; i + 1 < m_points.size(); ++i)
	{
		const Eigen::Vector3d before = m_points[i] - m_points[i - 1], after = m_points[i + 1] - m_points[i];
		m_speed_mps[i] = robot.max_speed_mps * std::max(0.0, before.normalized().dot(after.normalized()));
	}
}

Eigen::Vector3d PathFollower::pointAt(double along_m) const
{
	const auto next = std::upper_bound(m_along_m.begin(), m_along_m.end(), along_m);
	if (next == m_along_m.end()) return m_points.back();
	const auto index = static_cast<std::size_t>(next - m_along_m.begin());
	const double start = m_along_m[index - 1], length = m_along_m[index] - start;
	return m_points[index - 1] + (along_m - start) / length * (m_points[index] - m_points[index - 1]);
}

/** The nearest point of the path, looked for forward only, so that a path that crosses itself is not cut short. */
void PathFollower::followProgress(const RobotState& state)
{
	const auto distance = [&](double along_m) { return (pointAt(along_m) - state.position_in_map).norm(); };
	double nearest = distance(m_progress_m);
	for (double along = m_progress_m; along <= std::min(m_progress_m + kLookAhead_m, m_along_m.back());
	     along += kProgressStep_m)
		if (const double here = distance(along); here < nearest)
		{
			nearest = here;
			m_progress_m = along;
		}
	const bool at_end = m_along_m.back() - m_progress_m <= kNearEnough_m;
	m_done = m_done || (at_end && distance(m_along_m.back()) <= kNearEnough_m);
}

/** From which the robot can brake to what each point ahead allows. */
double PathFollower::allowedSpeed(const RobotState& state) const
{
	const double slowest = std::min(kSlowest_mps, m_robot.max_speed_mps);
	const double braking_mps2 = kBrakingShare * m_robot.max_acceleration_mps2;
	double speed = m_robot.max_speed_mps;
	for (std::size_t i = 1; i < m_points.size(); ++i)
	{
		if (m_along_m[i] <= m_progress_m && i + 1 < m_points.size()) continue;
		const double way_m = std::max(m_along_m[i] - m_progress_m, (m_points[i] - state.position_in_map).norm());
		speed = std::min(speed, std::sqrt(m_speed_mps[i] * m_speed_mps[i] + 2.0 * braking_mps2 * way_m));
	}
	return std::max(speed, slowest);
}

Command PathFollower::steer(const RobotState& state)
{
	followProgress(state);
	Command command;
	if (m_done) return command;

	const Eigen::Vector3d target = pointAt(std::min(m_progress_m + kLookAhead_m, m_along_m.back()));
	const Eigen::Vector3d way = target - state.position_in_map;
	const double aside_rad = wrapToPi(azimuthOf(way) - state.yaw_rad), distance_m = way.head<2>().norm();
	// What climbs straight up or down has no heading to turn to.
	const bool upright = distance_m < 0.2 * std::abs(way.z());
	double speed_mps = allowedSpeed(state);

	command.yaw_rate_radps = upright ? 0.0 : kYawGain_per_s * aside_rad;
	if (!upright && std::abs(aside_rad) > kTurnOnTheSpot_rad) return command;
	if (m_robot.kind == RobotKind::mav)
	{
		const Eigen::AngleAxisd level_from_map(-state.yaw_rad, Eigen::Vector3d::UnitZ());
		command.velocity_mps = level_from_map * way.normalized() * speed_mps;
		return command;
	}
	// The arc through the target has the curvature 2 sin(aside) / distance.
	const double curvature = 2.0 * std::sin(aside_rad) / std::max(distance_m, kNearEnough_m);
	speed_mps *= std::cos(aside_rad);
	const double turning = std::abs(speed_mps * curvature);
	if (turning > m_robot.max_yaw_rate_radps) speed_mps *= m_robot.max_yaw_rate_radps / turning;
	command.velocity_mps.x() = speed_mps;
	command.yaw_rate_radps = speed_mps * curvature;
	return command;
}
}  // namespace explore::simulation
