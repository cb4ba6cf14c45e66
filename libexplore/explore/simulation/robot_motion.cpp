#include <explore/core/geometry.h>
#include <explore/simulation/robot_motion.h>

#include <algorithm>
#include <cmath>

namespace explore::simulation
{
namespace
{
constexpr double kTiltLag_s = 0.15;
/** Four times the lag of the tilt: the speed settles without overshoot. */
constexpr double kSpeedLag_s = 4.0 * kTiltLag_s;
constexpr double kClimbLag_s = 0.3;

double toward(double value, double target, double most)
{
	return value + std::clamp(target - value, -most, most);
}

template <class Vector>
Vector limited(const Vector& vector, double most)
{
	const double length = vector.norm();
	return length > most ? Vector(vector * (most / length)) : vector;
}

void turn(RobotState& state, const Command& command, const MotionLimits& limits, double dt_s)
{
	const double most = limits.robot.max_yaw_rate_radps;
	state.yaw_rate_radps = toward(state.yaw_rate_radps, std::clamp(command.yaw_rate_radps, -most, most),
	                              limits.max_yaw_acceleration_radps2 * dt_s);
	state.yaw_rad = wrapToPi(state.yaw_rad + state.yaw_rate_radps * dt_s);
}

RobotState driven(RobotState state, const Command& command, const MotionLimits& limits, double dt_s)
{
	const RobotConfig& robot = limits.robot;
	const auto forward = [](double yaw_rad) { return Eigen::Vector3d(std::cos(yaw_rad), std::sin(yaw_rad), 0.0); };
	const double target = std::clamp(command.velocity_mps.x(), -robot.max_speed_mps, robot.max_speed_mps);
	const double speed =
	    toward(state.velocity_mps.dot(forward(state.yaw_rad)), target, robot.max_acceleration_mps2 * dt_s);
	const Eigen::Vector3d before = state.velocity_mps;
	const double yaw_before = state.yaw_rad;
	turn(state, command, limits, dt_s);
	// The wheels roll along the heading in the middle of the step: an arc, but for terms of its angle squared.
	state.position_in_map += speed * dt_s * forward(yaw_before + 0.5 * state.yaw_rate_radps * dt_s);
	state.velocity_mps = speed * forward(state.yaw_rad);
	state.acceleration_mps2 = (state.velocity_mps - before) / dt_s;
	return state;
}

RobotState flown(RobotState state, const Command& command, const MotionLimits& limits, double dt_s)
{
	const RobotConfig& robot = limits.robot;
	const Eigen::AngleAxisd map_from_level(state.yaw_rad, Eigen::Vector3d::UnitZ());
	const Eigen::Vector3d velocity = map_from_level.inverse() * state.velocity_mps;
	const Eigen::Vector3d target = limited(command.velocity_mps, robot.max_speed_mps);

	// It leans toward where it wants to accelerate: nose down (positive pitch) for forward, right side up for left.
	const Eigen::Vector2d wanted =
	    limited(Eigen::Vector2d((target - velocity).head<2>() / kSpeedLag_s), robot.max_acceleration_mps2);
	const auto lean = [&](double angle_rad)
	{ return std::clamp(angle_rad, -limits.max_tilt_rad, limits.max_tilt_rad); };
	const double share = 1.0 - std::exp(-dt_s / kTiltLag_s);
	state.pitch_rad += share * (lean(std::atan(wanted.x() / kGravity_mps2)) - state.pitch_rad);
	state.roll_rad +=
	    share * (lean(-std::atan(wanted.y() * std::cos(state.pitch_rad) / kGravity_mps2)) - state.roll_rad);

	const double climb = std::clamp((target.z() - velocity.z()) / kClimbLag_s, -robot.max_acceleration_mps2,
	                                robot.max_acceleration_mps2);
	const Eigen::Vector3d acceleration(kGravity_mps2 * std::tan(state.pitch_rad),
	                                   -kGravity_mps2 * std::tan(state.roll_rad) / std::cos(state.pitch_rad), climb);
	state.acceleration_mps2 = map_from_level * acceleration;
	state.position_in_map += (state.velocity_mps + 0.5 * dt_s * state.acceleration_mps2) * dt_s;
	state.velocity_mps += state.acceleration_mps2 * dt_s;
	turn(state, command, limits, dt_s);
	return state;
}
}  // namespace

RobotState moved(const RobotState& state, const Command& command, const MotionLimits& limits, double dt_s)
{
	RobotState next = limits.robot.kind == RobotKind::ground ? driven(state, command, limits, dt_s)
	                                                         : flown(state, command, limits, dt_s);
	next.t_s += dt_s;
	return next;
}
}  // namespace explore::simulation
