#include <explore/config/simulated_robot.h>

#include <array>

namespace explore::simulation
{
namespace
{
void describe(FieldVisitor& fields, OdometryConfig& odometry)
{
	fields.real("distance_noise", odometry.distance_noise, {0.0, 1.0}, "",
	            "Error of the travelled distance, a random walk: 0.01 is 1 cm after one metre, 2 cm after four.");
	fields.degrees("yaw_noise_deg", odometry.yaw_noise_rad, {0.0, 90.0},
	               "Error of the heading after one metre of travel; grows with the root of the distance.");
	fields.real("turn_noise", odometry.turn_noise, {0.0, 1.0}, "",
	            "Error of the heading after one radian of turning, in radians; grows with the root of the angle.");
	fields.real("height_noise", odometry.height_noise_m, {0.0, 1.0}, "m",
	            "mav only: error of the altitude; it wanders but does not grow.");
	fields.degrees("tilt_noise_deg", odometry.tilt_noise_rad, {0.0, 45.0},
	               "mav only: error of roll and pitch; it wanders but does not grow.");
}

void describe(FieldVisitor& fields, ImuConfig& imu)
{
	fields.real("imu_rate", imu.rate_hz, {1.0, 1000.0}, "Hz", "Readings a second.");
	fields.real("acceleration_noise", imu.acceleration_noise_mps2, {0.0, 10.0}, "m/s^2",
	            "Noise of each reading, each axis.");
	fields.degreesPerSecond("rate_noise_deg", imu.rate_noise_radps, {0.0, 90.0}, "Noise of each reading, each axis.");
	fields.real("acceleration_bias", imu.acceleration_bias_mps2, {0.0, 10.0}, "m/s^2",
	            "Standard deviation of the constant error of each axis, drawn from the seed.");
	fields.degreesPerSecond("rate_bias_deg", imu.rate_bias_radps, {0.0, 90.0},
	                        "Standard deviation of the constant error of each axis, drawn from the seed.");
}
}  // namespace

void describe(FieldVisitor& fields, SimulatedRobotConfig& config)
{
	static constexpr std::array<std::string_view, 2> kShapes{"cylinder", "capsule"};

	fields.section("simulated_robot", "What the simulator's robots do beyond [robot], and how well they know it.");
	fields.choice("body", config.body, kShapes,
	              "The solid that may not touch anything, of [robot]'s radius and height. A capsule is rounded at both "
	              "ends, a sphere where the height is less than the diameter.");
	fields.angle("max_yaw_acceleration_deg", config.max_yaw_acceleration_radps2, {1.0, 10000.0}, "deg/s^2",
	             "How fast the turning rate changes.");
	fields.degrees("max_tilt_deg", config.max_tilt_rad, {1.0, 45.0},
	               "mav only: greatest roll and pitch; it leans to accelerate.");
	describe(fields, config.odometry);
	describe(fields, config.imu);
}
}  // namespace explore::simulation
