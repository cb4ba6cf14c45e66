// The simulated robots in free space: limits, dynamics, and what their IMU feels.
#include <explore/core/geometry.h>
#include <explore/simulation/simulated_robot.h>

#include <gmock/gmock.h>

#include <cmath>

#include "box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using mrpt::poses::CPose3D;

namespace
{
/** No errors: what is measured is the motion itself. */
SimulatedRobotConfig exact()
{
	SimulatedRobotConfig config;
	config.odometry = {0, 0, 0, 0, 0};
	config.imu = {50, 0, 0, 0, 0};
	return config;
}

/** A robot alone in the void. */
struct Flight
{
	World world;
	RayScene scene{world};
	SimulatedRobot robot;

	explicit Flight(const RobotConfig& config, const CPose3D& start = {}) : robot(scene, config, exact(), start, 1) {}
	const RobotState& run(const Command& command, double seconds, double dt_s = 0.02)
	{
		for (int i = 0; i < std::lround(seconds / dt_s); ++i) robot.advance(command, dt_s);
		return robot.trueState();
	}
};

Command forward(double speed_mps, double yaw_rate_radps = 0)
{
	return {{speed_mps, 0, 0}, yaw_rate_radps};
}
}  // namespace

TEST(RobotMotion, AGroundRobotSpeedsUpAndBrakesAtItsAcceleration)
{
	Flight drive{RobotConfig{}};  // 0.5 m/s, 0.5 m/s²
	EXPECT_NEAR(drive.run(forward(2.0), 0.5).velocity_mps.x(), 0.25, 1e-9);
	EXPECT_NEAR(drive.run(forward(2.0), 1.5).velocity_mps.x(), 0.5, 1e-9);
	// One second of speeding up covers 0.25 m, the second after it 0.5 m.
	EXPECT_NEAR(drive.robot.trueState().position_in_map.x(), 0.75, 0.01);
	EXPECT_NEAR(drive.run(forward(0.0), 1.0).velocity_mps.x(), 0.0, 1e-9);
	EXPECT_NEAR(drive.robot.trueState().position_in_map.x(), 1.0, 0.015);
	EXPECT_LT(drive.run(forward(-2.0), 3.0).velocity_mps.x(), -0.49);
}

TEST(RobotMotion, AGroundRobotDrivesArcsAndNeverSideways)
{
	Flight drive{RobotConfig{}};
	drive.run(forward(0.4, 0.5), 2.0);
	// In full motion: a circle of 0.4 / 0.5 m, all around in 4π s.
	const Vector3d start = drive.robot.trueState().position_in_map;
	const RobotState half = drive.run(forward(0.4, 0.5), 2 * M_PI, 2 * M_PI / 314);
	EXPECT_NEAR((half.position_in_map - start).norm(), 1.6, 0.005);
	const RobotState whole = drive.run(forward(0.4, 0.5), 2 * M_PI, 2 * M_PI / 314);
	EXPECT_LT((whole.position_in_map - start).norm(), 0.005);

	Command aside;
	aside.velocity_mps = {0, 0.5, 0.5};
	Flight still{RobotConfig{}};
	EXPECT_EQ(still.run(aside, 1.0).position_in_map, Vector3d(0, 0, 0));
}

TEST(RobotMotion, TurningIsLimitedToo)
{
	Flight drive{RobotConfig{}};  // 1 rad/s, 200°/s²
	EXPECT_NEAR(drive.run(forward(0, 5.0), 0.1).yaw_rate_radps, 20 * kDegree_rad, 1e-9);
	EXPECT_NEAR(drive.run(forward(0, 5.0), 1.0).yaw_rate_radps, 1.0, 1e-9);
}

TEST(RobotMotion, AMavLeansTheWayItAccelerates)
{
	RobotConfig fast = mav();
	fast.max_acceleration_mps2 = 5.0;
	fast.max_speed_mps = 3.0;
	Flight flight(fast, {0, 0, 1.0, 90 * kDegree_rad, 0, 0});
	const RobotState leaning = flight.run(forward(3.0), 0.6);
	EXPECT_GT(leaning.pitch_rad, 8 * kDegree_rad);  // nose down
	EXPECT_LE(leaning.pitch_rad, 10 * kDegree_rad);
	EXPECT_GT(leaning.velocity_mps.y(), 0.3);  // its x axis looks along the map's y
	const RobotState cruising = flight.run(forward(3.0), 10.0);
	EXPECT_NEAR(cruising.velocity_mps.y(), 3.0, 0.01);
	EXPECT_NEAR(cruising.pitch_rad, 0.0, 0.1 * kDegree_rad);
	const RobotState braking = flight.run(forward(0.0), 0.4);
	EXPECT_LT(braking.pitch_rad, -6 * kDegree_rad);

	Command left;
	left.velocity_mps = {0, 0.8, 0};
	Flight aside(fast, {0, 0, 1.0, 0, 0, 0});
	EXPECT_LT(aside.run(left, 0.3).roll_rad, -3 * kDegree_rad);  // right side up
	EXPECT_GT(aside.robot.trueState().velocity_mps.y(), 0.05);
}

TEST(RobotMotion, AMavSettlesWithoutOvershootAndKeepsItsHeight)
{
	Flight flight(mav(), {0, 0, 1.2, 0, 0, 0});
	double fastest = 0;
	for (int i = 0; i < 500; ++i)
	{
		flight.robot.advance(forward(0.8), 0.02);
		fastest = std::max(fastest, flight.robot.trueState().velocity_mps.norm());
		EXPECT_LE(std::abs(flight.robot.trueState().acceleration_mps2.norm()), 0.5 + 1e-6);
	}
	EXPECT_NEAR(fastest, 0.8, 0.01);
	EXPECT_DOUBLE_EQ(flight.robot.trueState().position_in_map.z(), 1.2);
	Command up;
	up.velocity_mps = {0, 0, 0.4};
	EXPECT_NEAR(flight.run(up, 4.0).velocity_mps.z(), 0.4, 0.01);
}

TEST(RobotImu, AtRestFeelsGravityUpward)
{
	Flight still{RobotConfig{}};
	EXPECT_LT((still.robot.imu().specific_force_mps2 - Vector3d(0, 0, 9.80665)).norm(), 1e-12);
	EXPECT_LT(still.robot.imu().rate_radps.norm(), 1e-12);
}

TEST(RobotImu, FeelsForwardAccelerationTheTurnAndItsCentripetalForce)
{
	Flight drive{RobotConfig{}};
	drive.run(forward(0.5), 0.5);
	EXPECT_NEAR(drive.robot.imu().specific_force_mps2.x(), 0.5, 1e-6);
	drive.run(forward(0.5, 0.8), 3.0);
	EXPECT_NEAR(drive.robot.imu().rate_radps.z(), 0.8, 1e-6);
	EXPECT_NEAR(drive.robot.imu().specific_force_mps2.y(), 0.5 * 0.8, 0.01);  // v · ω toward the centre, left
}

TEST(RobotImu, OfAMavFeelsNothingAlongItsOwnXAndY)
{
	// The propellers push along the body's z axis alone, and gravity is not felt.
	Flight flight(mav(), {0, 0, 1.0, 0.7, 0, 0});
	Command command;
	command.velocity_mps = {0.5, 0.4, 0.0};
	for (int i = 0; i < 200; ++i)
	{
		flight.robot.advance(command, 0.02);
		const Vector3d force = flight.robot.imu().specific_force_mps2;
		EXPECT_LT(force.head<2>().norm(), 0.05);
		EXPECT_NEAR(force.z(), 9.81, 0.05);
	}
}

TEST(RobotImu, HasTheNoiseThatItsConfigSays)
{
	World world;
	RayScene scene(world);
	SimulatedRobotConfig config = exact();
	config.imu.acceleration_noise_mps2 = 0.05;
	config.imu.rate_noise_radps = 0.004;
	SimulatedRobot robot(scene, {}, config, {}, 5);
	double squares = 0, rate_squares = 0;
	constexpr int kReadings = 4000;
	for (int i = 0; i < kReadings; ++i)
	{
		robot.advance({}, 0.02);
		squares += std::pow(robot.imu().specific_force_mps2.x(), 2);
		rate_squares += robot.imu().rate_radps.squaredNorm() / 3;
	}
	EXPECT_NEAR(std::sqrt(squares / kReadings), 0.05, 0.003);
	EXPECT_NEAR(std::sqrt(rate_squares / kReadings), 0.004, 0.0002);
}
