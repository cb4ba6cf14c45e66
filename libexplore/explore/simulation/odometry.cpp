#include <explore/core/geometry.h>
#include <explore/simulation/odometry.h>

#include <cmath>

namespace explore::simulation
{
namespace
{
constexpr double kWander_s = 1.0;

Eigen::Vector2d planPosition(const mrpt::poses::CPose3D& pose)
{
	return {pose.x(), pose.y()};
}
}  // namespace

void Odometry::Wander::advance(Random& random, double sigma, double dt_s)
{
	const double kept = std::exp(-dt_s / kWander_s);
	value = kept * value + random.gaussian(sigma * std::sqrt(1.0 - kept * kept));
}

Odometry::Odometry(const OdometryConfig& config, RobotKind kind, const mrpt::poses::CPose3D& map_from_start,
                   std::uint64_t seed)
    : m_config(config),
      m_kind(kind),
      m_true(map_from_start),
      m_position(planPosition(map_from_start)),
      m_yaw_rad(map_from_start.yaw()),
      m_random(seed)
{
}

void Odometry::moveTo(const mrpt::poses::CPose3D& map_from_robot, double dt_s)
{
	const Eigen::Rotation2Dd robot_from_map(-m_true.yaw());
	Eigen::Vector2d step = robot_from_map * (planPosition(map_from_robot) - planPosition(m_true));
	const double turn_rad = wrapToPi(map_from_robot.yaw() - m_true.yaw());
	const double climb_m = map_from_robot.z() - m_true.z();
	const double travelled_m = std::hypot(step.norm(), climb_m);

	const double distance_sigma = m_config.distance_noise * std::sqrt(travelled_m);
	const double yaw_sigma = std::sqrt(m_config.yaw_noise_rad * m_config.yaw_noise_rad * travelled_m +
	                                   m_config.turn_noise * m_config.turn_noise * std::abs(turn_rad));
	const Eigen::Vector2d along = step.norm() > 0.0 ? step.normalized() : Eigen::Vector2d::UnitX().eval();
	step += m_random.gaussian(distance_sigma) * along;
	// Wheels do not slip aside; what flies drifts to all sides.
	const double aside = m_random.gaussian(distance_sigma);
	if (m_kind == RobotKind::mav) step += aside * Eigen::Vector2d(-along.y(), along.x());

	m_position += Eigen::Rotation2Dd(m_yaw_rad) * step;
	m_yaw_rad = wrapToPi(m_yaw_rad + turn_rad + m_random.gaussian(yaw_sigma));
	m_height.advance(m_random, m_config.height_noise_m, dt_s);
	m_pitch.advance(m_random, m_config.tilt_noise_rad, dt_s);
	m_roll.advance(m_random, m_config.tilt_noise_rad, dt_s);
	m_true = map_from_robot;
}

mrpt::poses::CPose3D Odometry::estimate() const
{
	if (m_kind == RobotKind::ground) return {m_position.x(), m_position.y(), m_true.z(), m_yaw_rad, 0.0, 0.0};
	return {m_position.x(),
	        m_position.y(),
	        m_true.z() + m_height.value,
	        m_yaw_rad,
	        m_true.pitch() + m_pitch.value,
	        m_true.roll() + m_roll.value};
}

Imu::Imu(const ImuConfig& config, std::uint64_t seed) : m_config(config), m_random(seed)
{
	m_acceleration_bias = noise(config.acceleration_bias_mps2);
	m_rate_bias = noise(config.rate_bias_radps);
}

Eigen::Vector3d Imu::noise(double sigma)
{
	Eigen::Vector3d noise;
	for (double& axis : noise) axis = m_random.gaussian(sigma);
	return noise;
}

ImuReading Imu::read(const mrpt::poses::CPose3D& map_from_before, const mrpt::poses::CPose3D& map_from_robot,
                     const Eigen::Vector3d& acceleration_mps2, double dt_s)
{
	const Eigen::Matrix3d before = isometryOf(map_from_before).linear(), now = isometryOf(map_from_robot).linear();
	const Eigen::AngleAxisd turned(Eigen::Matrix3d(before.transpose() * now));
	ImuReading reading;
	reading.specific_force_mps2 =
	    now.transpose() * (acceleration_mps2 + kGravity_mps2 * Eigen::Vector3d::UnitZ()) + m_acceleration_bias;
	reading.rate_radps = turned.angle() * turned.axis() / dt_s + m_rate_bias;
	reading.specific_force_mps2 += noise(m_config.acceleration_noise_mps2);
	reading.rate_radps += noise(m_config.rate_noise_radps);
	return reading;
}
}  // namespace explore::simulation
