#include <explore/core/errors.h>
#include <explore/simulation/robot_body.h>
#include <explore/simulation/simulated_robot.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace explore::simulation
{
namespace
{
/** Steps are this short, so that a corner cannot slip through between two of them. */
constexpr double kStep_s = 0.02, kStep_m = 0.01;
constexpr double kContactEnds_m = 0.02;

RobotState stateAt(const mrpt::poses::CPose3D& map_from_robot, RobotKind kind)
{
	RobotState state;
	state.position_in_map = {map_from_robot.x(), map_from_robot.y(), map_from_robot.z()};
	state.yaw_rad = map_from_robot.yaw();
	if (kind == RobotKind::mav)
	{
		state.pitch_rad = map_from_robot.pitch();
		state.roll_rad = map_from_robot.roll();
	}
	return state;
}

std::string noRoomAt(const Eigen::Vector3d& place, const RobotConfig& robot)
{
	std::ostringstream message;
	message << "the robot (radius " << robot.radius_m << " m, height " << robot.height_m
	        << " m) touches something at its start (" << place.x() << ", " << place.y() << ", " << place.z()
	        << "): a place with more room is needed";
	return message.str();
}
}  // namespace

SimulatedRobot::SimulatedRobot(RayScene& scene, const RobotConfig& robot, const SimulatedRobotConfig& config,
                               const mrpt::poses::CPose3D& map_from_start, std::uint64_t seed)
    : m_scene(&scene),
      m_limits{robot, config.max_yaw_acceleration_radps2, config.max_tilt_rad},
      m_shape(config.body),
      m_state(stateAt(map_from_start, robot.kind)),
      m_movers(scene.world()),
      m_odometry(config.odometry, robot.kind, m_state.mapFromRobot(), mixed({seed, hashOf("odometry")})),
      m_imu(config.imu, mixed({seed, hashOf("imu")}))
{
	if (!m_movers.empty()) scene.place(m_movers.placement());
	if (touchesAt(m_state.position_in_map)) throw ConfigError(noRoomAt(m_state.position_in_map, robot));
	const auto pose = m_state.mapFromRobot();
	m_imu_reading = m_imu.read(pose, pose, Eigen::Vector3d::Zero(), kStep_s);
}

bool SimulatedRobot::touchesAt(const Eigen::Vector3d& position_in_map) const
{
	const VerticalCylinder body = bodyAt(m_limits.robot, position_in_map);
	if (m_shape == BodyShape::cylinder) return m_scene->touchesCylinder(body.base, body.radius_m, body.height_m);
	const double low = std::min(body.radius_m, 0.5 * body.height_m);
	const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
	return m_scene->touchesCapsule(body.base + low * up, body.base + (body.height_m - low) * up, body.radius_m);
}

void SimulatedRobot::advance(const Command& command, double dt_s)
{
	const RobotState before = m_state;
	const double fastest_mps = std::max(m_limits.robot.max_speed_mps, m_state.velocity_mps.norm());
	const int steps = std::max(1, static_cast<int>(std::ceil(dt_s / std::min(kStep_s, kStep_m / fastest_mps) - 1e-9)));
	for (int i = 0; i < steps; ++i) step(command, dt_s / steps);
	m_state.t_s = before.t_s + dt_s;

	const Eigen::Vector3d acceleration = (m_state.velocity_mps - before.velocity_mps) / dt_s;
	m_imu_reading = m_imu.read(before.mapFromRobot(), m_state.mapFromRobot(), acceleration, dt_s);
}

void SimulatedRobot::step(const Command& command, double dt_s)
{
	moveMovers(dt_s);
	RobotState next = moved(m_state, command, m_limits, dt_s);
	const bool moves = next.position_in_map != m_state.position_in_map;
	if (moves && touchesAt(next.position_in_map))
		stopAtContact(next);
	else
		m_state = next;
	if (m_in_contact && (m_state.position_in_map - m_contacts.back().position_in_map).norm() > kContactEnds_m)
		m_in_contact = false;
	m_odometry.moveTo(m_state.mapFromRobot(), dt_s);
}

void SimulatedRobot::moveMovers(double dt_s)
{
	if (m_movers.empty()) return;
	m_movers.advance(dt_s, {m_state.position_in_map.head<2>(), m_limits.robot.radius_m});
	m_scene->place(m_movers.placement());
}

/** Goes as far as there is room; the body's turning is free, for it is round. */
void SimulatedRobot::stopAtContact(const RobotState& target)
{
	const Eigen::Vector3d from = m_state.position_in_map, way = target.position_in_map - from;
	double free = 0.0, blocked = 1.0;
	for (int i = 0; i < 10; ++i)
	{
		const double middle = 0.5 * (free + blocked);
		(touchesAt(from + middle * way) ? blocked : free) = middle;
	}
	m_state = target;
	m_state.position_in_map = from + free * way;
	m_state.velocity_mps.setZero();
	m_state.acceleration_mps2.setZero();
	if (!m_in_contact) m_contacts.push_back({m_state.t_s, m_state.position_in_map});
	m_in_contact = true;
}
}  // namespace explore::simulation
