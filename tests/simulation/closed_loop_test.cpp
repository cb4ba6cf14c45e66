// The closed loop: frames come at the camera's times, commands take effect after the delay, truth and estimate differ.
#include <explore/core/errors.h>
#include <explore/simulation/closed_loop.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;

namespace
{
ClosedLoopConfig usual(const char* camera = "xtion")
{
	ClosedLoopConfig config;
	config.recorder.camera = depthCamera(camera, 64);
	config.recorder.robot_from_camera = usualMount(RobotKind::ground);
	config.recorder.start = mrpt::Clock::fromDouble(kUsualStart_s);
	config.recorder.seed = 7;
	return config;
}

Command forward(double speed_mps, double yaw_rate_radps = 0)
{
	return {{speed_mps, 0, 0}, yaw_rate_radps};
}

/** `count` frames, every one answered by `command`. */
std::vector<DepthFrame> drive(ClosedLoop& loop, int count, const Command& command)
{
	std::vector<DepthFrame> frames;
	for (int i = 0; i < count; ++i)
	{
		frames.push_back(loop.next());
		loop.obey(command);
	}
	return frames;
}
}  // namespace

TEST(ClosedLoop, FramesComeAtTheCamerasTimesAndTheRobotWaitsForItsFirstCommand)
{
	const World world = hall();
	RayScene scene(world);
	ClosedLoop loop(scene, usual());
	for (std::size_t i = 0; i < 5; ++i)
	{
		const DepthFrame frame = loop.next();
		EXPECT_EQ(frame.index, i);
		EXPECT_NEAR(mrpt::Clock::toDouble(frame.timestamp), 1.6e9 + 0.1 * static_cast<double>(i), 1e-6);
		EXPECT_EQ(frame.sensor_label, "XTION");
		EXPECT_EQ(frame.image.intrinsics.width_px, 64);
		EXPECT_EQ(frame.map_from_robot.x(), 0.0);
	}
	EXPECT_FALSE(loop.minClearance());
}

TEST(ClosedLoop, TheWallComesNearerAsTheRobotDrives)
{
	const World world = hall();
	RayScene scene(world);
	ClosedLoop loop(scene, usual("ideal"));
	const auto frames = drive(loop, 51, forward(0.4));
	for (const DepthFrame& frame : frames)
	{
		// The camera is 0.1 m ahead of the robot's centre.
		const double expected_m = 10.0 - 0.1 - frame.map_from_robot.x();
		EXPECT_NEAR(frame.image.at(32, 24), expected_m, 0.002);
	}
	// 5 s but for the delay, and the half of the 0.8 s of speeding up.
	EXPECT_NEAR(frames.back().map_from_robot.x(), 0.4 * (5.0 - 0.05 - 0.4), 0.01);
}

TEST(ClosedLoop, ACommandTakesEffectAfterItsDelay)
{
	const World world = hall();
	for (const double delay_s : {0.0, 0.05, 0.09})
	{
		RayScene scene(world);
		ClosedLoopConfig config = usual();
		config.command_delay_s = delay_s;
		ClosedLoop loop(scene, config);
		drive(loop, 1, forward(0.5));
		const double moving_s = 0.1 - delay_s;
		EXPECT_NEAR(loop.next().map_from_robot.x(), 0.5 * 0.5 * moving_s * moving_s, 6e-4) << delay_s;
	}
}

TEST(ClosedLoop, ADelayAsLongAsAFrameIsRefused)
{
	const World world = hall();
	RayScene scene(world);
	ClosedLoopConfig config = usual();
	config.command_delay_s = 0.1;
	EXPECT_THROW(ClosedLoop(scene, config), ConfigError);
}

TEST(ClosedLoop, SameSeedSameFramesOtherSeedOtherNoise)
{
	const World world = hall();
	const auto run = [&](std::uint64_t seed)
	{
		RayScene scene(world);
		ClosedLoopConfig config = usual();
		config.recorder.seed = seed;
		config.exact_pose = false;
		ClosedLoop loop(scene, config);
		return drive(loop, 20, forward(0.3, 0.4));
	};
	const auto first = run(1), again = run(1), other = run(2);
	for (std::size_t i = 0; i < first.size(); ++i)
	{
		EXPECT_EQ(first[i].image.depth_m, again[i].image.depth_m);
		EXPECT_EQ(first[i].map_from_robot.x(), again[i].map_from_robot.x());
		EXPECT_NE(first[i].image.depth_m, other[i].image.depth_m);
	}
	EXPECT_NE(first.back().map_from_robot.x(), other.back().map_from_robot.x());
}

TEST(ClosedLoop, ExactPoseIsTheTrueOneAndOdometryDrifts)
{
	const World world = hall();
	for (const bool exact : {true, false})
	{
		RayScene scene(world);
		ClosedLoopConfig config = usual();
		config.exact_pose = exact;
		ClosedLoop loop(scene, config);
		const auto frames = drive(loop, 100, forward(0.5));
		const auto truth = loop.robot().trueState().mapFromRobot();
		EXPECT_EQ(frames[0].map_from_robot.x(), 0.0);
		EXPECT_EQ(frames.back().map_from_robot.distanceTo(truth) == 0.0, exact);
		EXPECT_LT(frames.back().map_from_robot.distanceTo(truth), 0.5);
		EXPECT_EQ(frames.back().pose_origin, exact ? PoseOrigin::robot_pose : PoseOrigin::odometry);
	}
}

TEST(ClosedLoop, ImuReadingsAreHandedOverInTheirOrder)
{
	const World world = hall();
	RayScene scene(world);
	ClosedLoop loop(scene, usual());
	std::vector<double> times_s;
	const ObservationSink sink = [&](const mrpt::obs::CObservation& observation)
	{ times_s.push_back(mrpt::Clock::toDouble(observation.timestamp)); };
	for (int i = 0; i < 11; ++i)
	{
		loop.next(sink);
		loop.obey(forward(0.2));
	}
	EXPECT_GE(times_s.size(), 50U);
	EXPECT_TRUE(std::is_sorted(times_s.begin(), times_s.end()));
	EXPECT_NEAR(times_s.back(), 1.6e9 + 1.0, 1e-6);
}

TEST(ClosedLoop, KnowsItsLeastClearanceAndItsContacts)
{
	const World world = hall();
	RayScene scene(world);
	ClosedLoopConfig config = usual();
	config.map_from_start = mrpt::poses::CPose3D(0.0, 2.6, 0.0, 0, 0, 0);
	ClosedLoop along(scene, config);
	drive(along, 50, forward(0.5));
	ASSERT_TRUE(along.minClearance());
	EXPECT_NEAR(*along.minClearance(), 3.0 - 2.6 - 0.22, 0.0015);
	EXPECT_TRUE(along.robot().contacts().empty());

	config.map_from_start = mrpt::poses::CPose3D(0.0, 2.6, 0.0, M_PI / 2, 0, 0);
	ClosedLoop into(scene, config);
	drive(into, 50, forward(0.5));
	EXPECT_EQ(into.robot().contacts().size(), 1U);
	EXPECT_LT(into.minClearance().value_or(1.0), 0.002);
}
