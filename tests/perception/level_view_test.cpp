#include <explore/core/geometry.h>
#include <explore/perception/level_view.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "support/analytic_scene.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;

RobotConfig robotOf(RobotKind kind)
{
	RobotConfig robot;
	robot.kind = kind;
	return robot;
}

LevelView viewOf(const DepthFrame& frame, RobotKind kind = RobotKind::ground, const GroundMemory& memory = {},
                 const LevelViewConfig& config = {})
{
	return levelView(frame, robotOf(kind), memory, config, {});
}

/** Truth: the map's z is up and its floor at 0. */
double tiltError(const DepthFrame& frame, const LevelPose& pose)
{
	const Eigen::Isometry3d map_from_camera = isometryOf(frame.map_from_robot + frame.robot_from_camera);
	const Eigen::Vector3d up_in_map = map_from_camera.linear() * pose.level_from_camera.linear().transpose().col(2);
	return std::acos(std::min(1.0, up_in_map.z()));
}

double heightError(const DepthFrame& frame, const LevelPose& pose)
{
	return pose.cameraHeight_m() - (frame.map_from_robot + frame.robot_from_camera).z();
}

Eigen::Vector3d trueUpInRobot(const DepthFrame& frame)
{
	return isometryOf(frame.map_from_robot).linear().transpose() * Eigen::Vector3d::UnitZ();
}

/** A room of 6 m × 5 m × 2.6 m whose floor is at 0. */
test::Scene room()
{
	test::Scene scene;
	scene.floor(-1, -2.5, 5, 2.5).floor(-1, -2.5, 5, 2.5, 2.6);
	scene.wall({5, -2.5}, {5, 2.5}, 2.6).wall({-1, 2.5}, {5, 2.5}, 2.6).wall({-1, -2.5}, {5, -2.5}, 2.6);
	return scene;
}

const CameraIntrinsics kQvga = test::xtionIntrinsics(320, 240);

DepthFrame frameOf(const test::Scene& scene, const CPose3D& map_from_robot, const CPose3D& mount,
                   std::uint32_t seed = 1)
{
	test::CameraNoise noise;
	noise.axial_scale = 1.0;
	noise.seed = seed;
	return test::renderFrame(scene, map_from_robot, mount, kQvga, noise);
}

/** Share of the pixels that see the floor, by the true pose. */
double floorShare(const DepthFrame& frame)
{
	const Eigen::Isometry3d map_from_camera = isometryOf(frame.map_from_robot + frame.robot_from_camera);
	std::size_t on_floor = 0;
	for (int v = 0; v < kQvga.height_px; ++v)
		for (int u = 0; u < kQvga.width_px; ++u)
		{
			const auto depth = static_cast<double>(frame.image.at(u, v));
			const Eigen::Vector3d point_in_map = map_from_camera * (depth * rayOfPixel(kQvga, u, v));
			on_floor += static_cast<std::size_t>(depth > 0.0 && std::abs(point_in_map.z()) < 0.03);
		}
	return static_cast<double>(on_floor) / static_cast<double>(frame.image.depth_m.size());
}

TEST(LevelView, FindsTheFloorFromAnyAttitudeWithGravityKnownToADegree)
{
	std::mt19937 random(5);
	std::uniform_real_distribution<double> unit(-1, 1);
	const test::Scene scene = room();
	int seen = 0;
	for (int i = 0; i < 40; ++i)
	{
		const CPose3D pose(0.5 * unit(random), unit(random), 1.2 + 0.5 * unit(random), 0.4 * unit(random),
		                   30 * kDegree_rad * unit(random), 30 * kDegree_rad * unit(random));
		DepthFrame frame = frameOf(scene, pose, CPose3D(0.1, 0, 0, 0, 0, 0), static_cast<std::uint32_t>(i));
		const Eigen::AngleAxisd error(kDegree_rad * unit(random),
		                              Eigen::Vector3d(unit(random), unit(random), 0).normalized());
		frame.up_in_robot = error * trueUpInRobot(frame);
		const LevelPose level = viewOf(frame, RobotKind::mav).pose;
		EXPECT_LT(tiltError(frame, level), 1.2 * kDegree_rad) << i;
		if (floorShare(frame) > 0.05)
		{
			EXPECT_EQ(level.floor, FloorOrigin::seen) << i;
		}
		if (level.floor != FloorOrigin::seen) continue;
		++seen;
		EXPECT_NEAR(heightError(frame, level), 0.0, 0.03) << i;
		EXPECT_LT(tiltError(frame, level), 0.6 * kDegree_rad) << i;
	}
	EXPECT_GE(seen, 15);
}

TEST(LevelView, SurfacesCorrectAVerticalThatIsHardlyKnown)
{
	for (const auto& [pitch_deg, roll_deg] : {std::array{10.0, 0.0}, {0.0, -12.0}, {8.0, 9.0}, {-6.0, 10.0}})
	{
		const CPose3D pose(0, 0.3, 1.4, 0.2, pitch_deg * kDegree_rad, roll_deg * kDegree_rad);
		const DepthFrame frame = frameOf(room(), pose, CPose3D(0.1, 0, 0, 0, 0, 0));
		const LevelPose level = viewOf(frame, RobotKind::mav).pose;
		EXPECT_LT(tiltError(frame, level), 1.5 * kDegree_rad) << pitch_deg << ' ' << roll_deg;
	}
}

TEST(LevelView, ARecordedVerticalThatIsWrongDoesNotDestroyAClearFloor)
{
	DepthFrame frame = frameOf(room(), CPose3D(0, 0.3, 0, 0.2, 0, 0), CPose3D(0.1, 0, 0.9, 0, 0.1, 0));
	frame.up_in_robot = Eigen::AngleAxisd(14 * kDegree_rad, Eigen::Vector3d::UnitY()) * Eigen::Vector3d::UnitZ();
	const LevelPose level = viewOf(frame).pose;
	EXPECT_EQ(level.up, UpOrigin::surfaces);
	EXPECT_EQ(level.floor, FloorOrigin::seen);
	EXPECT_LT(tiltError(frame, level), 0.6 * kDegree_rad);
	EXPECT_NEAR(heightError(frame, level), 0.0, 0.03);
}

TEST(LevelView, AVerticalThatIsRightIsKeptWhereWallsAreFarAndNoisy)
{
	test::Scene scene;
	scene.wall({4.6, -6}, {4.6, 6}, 6.0);
	DepthFrame frame =
	    frameOf(scene, CPose3D(0, 0, 1.5, 0, -18 * kDegree_rad, 15 * kDegree_rad), CPose3D(0.1, 0, 0, 0, 0, 0));
	frame.up_in_robot = trueUpInRobot(frame);
	const LevelPose level = viewOf(frame, RobotKind::mav).pose;
	EXPECT_EQ(level.up, UpOrigin::imu);
	EXPECT_LT(tiltError(frame, level), 1.0 * kDegree_rad);
}

TEST(LevelView, TablesAndBoxesAreNoFloor)
{
	test::Scene scene = room();
	scene.box({1.6, 0.2, 0.35}, {1.2, 1.6, 0.7});
	const DepthFrame ground = frameOf(scene, {}, CPose3D(0.1, 0, 1.1, 0, 0.2, 0));
	EXPECT_NEAR(heightError(ground, viewOf(ground).pose), 0.0, 0.02);
	DepthFrame flying = frameOf(scene, CPose3D(0, 0, 1.5, 0, 0.2, 0), CPose3D(0.1, 0, 0, 0, 0, 0));
	flying.up_in_robot = trueUpInRobot(flying);
	const LevelPose level = viewOf(flying, RobotKind::mav).pose;
	EXPECT_EQ(level.floor, FloorOrigin::seen);
	EXPECT_NEAR(heightError(flying, level), 0.0, 0.03);
}

TEST(LevelView, ATableTopAloneDoesNotBecomeTheFloorOfAGroundRobot)
{
	test::Scene scene;
	scene.box({1.8, 0, 0.8}, {2.0, 3.0, 0.04}).wall({4, -3}, {4, 3}, 2.6);
	const DepthFrame frame = frameOf(scene, {}, CPose3D(0.1, 0, 1.2, 0, 0, 0));
	const LevelPose level = viewOf(frame).pose;
	EXPECT_EQ(level.floor, FloorOrigin::mount);
	EXPECT_NEAR(heightError(frame, level), 0.0, 0.01);
}

TEST(LevelView, TheFloorThatTheRobotStandsOnWinsOverOneFurtherDown)
{
	test::Scene scene;
	scene.floor(-1, -2, 1.9, 2).floor(1.9, -2, 6, 2, -1.2).wall({6, -2}, {6, 2}, 2.6);
	const DepthFrame frame = frameOf(scene, {}, CPose3D(0.1, 0, 1.1, 0, 0.35, 0));
	const LevelPose level = viewOf(frame).pose;
	EXPECT_EQ(level.floor, FloorOrigin::seen);
	EXPECT_NEAR(heightError(frame, level), 0.0, 0.02);
}

TEST(LevelView, AnUnseenFloorIsTheMountsTheRememberedOneOrAGuessWithinTheFlightBand)
{
	test::Scene wall;
	wall.floor(-1, -4, 1.0, 4).wall({2.0, -4}, {2.0, 4}, 3.0);
	const DepthFrame ground = frameOf(wall, {}, CPose3D(0.1, 0, 0.9, 0, -0.2, 0));
	EXPECT_EQ(viewOf(ground).pose.floor, FloorOrigin::mount);
	EXPECT_NEAR(heightError(ground, viewOf(ground).pose), 0.0, 0.01);

	DepthFrame flying = frameOf(wall, CPose3D(0.5, 0, 1.2, 0, -0.2, 0), CPose3D(0.1, 0, 0, 0, 0, 0));
	flying.up_in_robot = trueUpInRobot(flying);
	const LevelPose guessed = viewOf(flying, RobotKind::mav).pose;
	EXPECT_EQ(guessed.floor, FloorOrigin::guessed);
	EXPECT_GE(guessed.cameraHeight_m(), 0.1);
	EXPECT_LE(guessed.cameraHeight_m(), 2.4);

	DepthFrame before = frameOf(wall, CPose3D(-1.5, 0, 1.1, 0, 0.5, 0), CPose3D(0.1, 0, 0, 0, 0, 0));
	before.up_in_robot = trueUpInRobot(before);
	before.pose_origin = flying.pose_origin = PoseOrigin::robot_pose;
	// the map's origin is not on the floor, so that only the memory can tell
	before.map_from_robot.z_incr(7.0);
	flying.map_from_robot.z_incr(7.0);
	flying.timestamp = before.timestamp + std::chrono::milliseconds(800);
	const LevelView seen = viewOf(before, RobotKind::mav);
	ASSERT_EQ(seen.pose.floor, FloorOrigin::seen);
	const GroundMemory memory = remember(GroundMemory{}, before, seen.pose);
	const LevelPose remembered = viewOf(flying, RobotKind::mav, memory).pose;
	EXPECT_EQ(remembered.floor, FloorOrigin::remembered);
	EXPECT_NEAR(remembered.cameraHeight_m(), flying.map_from_robot.z() - 7.0 + 0.1 * std::sin(0.2), 0.05);
}

TEST(LevelView, MemoryFadesWithWayAndTimeAndEnds)
{
	DepthFrame frame = frameOf(room(), {}, CPose3D(0.1, 0, 0.9, 0, 0.2, 0));
	frame.pose_origin = PoseOrigin::odometry;
	const GroundMemory memory = remember(GroundMemory{}, frame, viewOf(frame).pose);
	const auto after = [&](double metres, double seconds)
	{
		DepthFrame later = frame;
		later.map_from_robot = CPose3D(metres, 0, 0, 0, 0, 0);
		later.timestamp += std::chrono::milliseconds(static_cast<int>(1000 * seconds));
		return recall(memory, later, {}, {});
	};
	ASSERT_TRUE(after(0, 0.1));
	EXPECT_NEAR(after(0, 0.1)->plane.d_m, 0.0, 0.02);
	EXPECT_GT(after(2, 2)->height_sigma_m, after(0, 2)->height_sigma_m);
	EXPECT_GT(after(0, 4)->tilt_sigma_rad, after(0, 1)->tilt_sigma_rad);
	EXPECT_FALSE(after(0, 60));
	EXPECT_FALSE(after(0, -1));
	EXPECT_FALSE(recall({}, frame, {}, {}));
}

TEST(LevelView, SamplesAreThePointsOfTheirPixels)
{
	const DepthFrame frame = frameOf(room(), {}, CPose3D(0.1, 0, 0.9, 0, 0.2, 0.05));
	const LevelView view = viewOf(frame);
	ASSERT_GT(view.samples.size(), 15000U);
	EXPECT_EQ(view.samples.stride, 2);
	for (std::size_t i = 0; i < view.samples.size(); i += 97)
	{
		const int u = view.samples.u[i], v = view.samples.v[i];
		ASSERT_EQ(frame.image.at(u, v), view.samples.depth_m[i]);
		const Eigen::Vector3d point_in_level =
		    view.pose.level_from_camera * (static_cast<double>(view.samples.depth_m[i]) * rayOfPixel(kQvga, u, v));
		EXPECT_NEAR(point_in_level.x(), static_cast<double>(view.samples.x[i]), 1e-4);
		EXPECT_NEAR(point_in_level.y(), static_cast<double>(view.samples.y[i]), 1e-4);
		EXPECT_NEAR(point_in_level.z(), static_cast<double>(view.samples.z[i]), 1e-4);
	}
}

TEST(LevelView, ThinsEveryImageSizeToAboutTheSame)
{
	EXPECT_EQ(sampleStride(test::xtionIntrinsics(640, 480)), 4);
	EXPECT_EQ(sampleStride(test::xtionIntrinsics(320, 240)), 2);
	EXPECT_EQ(sampleStride(test::xtionIntrinsics(160, 120)), 1);
	EXPECT_EQ(sampleStride(test::xtionIntrinsics(8, 6)), 1);
}

TEST(LevelView, WithoutTheGravityPriorTiltedViewsGiveNothing)
{
	LevelViewConfig config;
	config.gravity_prior = false;
	DepthFrame level = frameOf(room(), CPose3D(0, 0, 1.0, 0, 0, 0), CPose3D(0.1, 0, 0, 0, 0, 0));
	EXPECT_GT(viewOf(level, RobotKind::mav, {}, config).samples.size(), 0U);
	DepthFrame tilted = frameOf(room(), CPose3D(0, 0, 1.0, 0, 0, 0.6), CPose3D(0.1, 0, 0, 0, 0, 0));
	tilted.up_in_robot = trueUpInRobot(tilted);
	EXPECT_EQ(viewOf(tilted, RobotKind::mav, {}, config).samples.size(), 0U);
}

TEST(LevelView, DegenerateImagesGiveFinitePoses)
{
	const auto expect_finite = [](const DepthFrame& frame)
	{
		for (const RobotKind kind : {RobotKind::ground, RobotKind::mav})
		{
			const LevelView view = viewOf(frame, kind);
			EXPECT_TRUE(view.pose.level_from_camera.matrix().allFinite());
			EXPECT_TRUE(view.pose.robot_from_level.matrix().allFinite());
			EXPECT_NEAR(view.pose.level_from_camera.linear().determinant(), 1.0, 1e-6);
			for (const float z : view.samples.z) ASSERT_TRUE(std::isfinite(z));
		}
	};
	DepthFrame frame;
	expect_finite(frame);  // unorganised: no image
	std::mt19937 random(3);
	for (const auto& [width, height] : {std::array{640, 480}, {8, 6}, {3, 2}, {1, 1}})
	{
		frame.image.intrinsics = test::xtionIntrinsics(width, height);
		frame.image.depth_m.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F);
		expect_finite(frame);
		for (float& depth : frame.image.depth_m) depth = 2.0F;
		expect_finite(frame);
		for (float& depth : frame.image.depth_m) depth = static_cast<float>(random() % 9000) * 1e-3F;
		expect_finite(frame);
	}
	frame.robot_from_camera = CPose3D(0, 0, 1, 0, 90 * kDegree_rad, 0);  // straight down
	expect_finite(frame);
	frame.up_in_robot = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
	expect_finite(frame);
}
}  // namespace
}  // namespace explore
