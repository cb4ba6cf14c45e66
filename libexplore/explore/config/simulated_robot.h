// [simulated_robot]: what the simulated robots do beyond [robot], and how well they know where they are.
#pragma once

#include <explore/config/fields.h>

namespace explore::simulation
{
enum class BodyShape
{
	cylinder,
	capsule,
};

/** A random walk: after d metres of travel its standard deviation has grown by the given figure · √(d / 1 m). */
struct OdometryConfig
{
	double distance_noise = 0.01;               ///< of a metre's length
	double yaw_noise_rad = 0.008726646259972;   ///< a metre (0.5°)
	double turn_noise = 0.01;                   ///< of a radian turned on the spot, grows with its root
	double height_noise_m = 0.02;               ///< MAV only, does not grow
	double tilt_noise_rad = 0.005235987755983;  ///< MAV only, roll and pitch, does not grow (0.3°)
};

struct ImuConfig
{
	double rate_hz = 50.0;
	double acceleration_noise_mps2 = 0.05, rate_noise_radps = 0.003490658503989;  ///< white, each reading (0.2°/s)
	double acceleration_bias_mps2 = 0.02, rate_bias_radps = 0.003490658503989;    ///< drawn once, each axis
};

struct SimulatedRobotConfig
{
	BodyShape body = BodyShape::cylinder;
	double max_yaw_acceleration_radps2 = 3.490658503988659;  ///< 200°/s²
	double max_tilt_rad = 0.174532925199433;                 ///< MAV only (10°)
	OdometryConfig odometry;
	ImuConfig imu;
};

/** [simulated_robot] */
void describe(FieldVisitor& fields, SimulatedRobotConfig& config);
}  // namespace explore::simulation
