#include <explore/core/geometry.h>
#include <explore/navigation/avoider.h>
#include <explore/perception/obstacles.h>
#include <gtest/gtest.h>

#include <cmath>

#include "obstacle_scenes.h"
#include "support/analytic_scene.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;
using test::Scene;
constexpr double kHalfView = 28.6 * kDegree_rad;
constexpr double kHull_m = 0.22;
const CPose3D kLowMount(0.1, 0.0, 0.5, 0, 0, 0);

/** What the avoider makes of one frame of a scene. */
struct Look
{
	DepthFrame frame;
	RobotConfig robot;
	AvoiderConfig config;
	double desired_rad = 0;

	explicit Look(const Scene& scene, const CPose3D& mount = kLowMount, const test::CameraNoise& noise = {})
	    : frame(test::renderFrame(scene, {}, mount, test::xtionIntrinsics(320, 240), noise))
	{
	}
	/** Blots out what the camera sees of `black`: the pixels that differ from the scene without it. */
	Look& blackOut(const Scene& without_it, const CPose3D& mount = kLowMount)
	{
		const DepthFrame behind = test::renderFrame(without_it, {}, mount, test::xtionIntrinsics(320, 240), {});
		for (std::size_t i = 0; i < frame.image.depth_m.size(); ++i)
			if (frame.image.depth_m[i] != behind.image.depth_m[i]) frame.image.depth_m[i] = 0.0F;
		return *this;
	}
	[[nodiscard]] Avoidance avoidance() const
	{
		const Plane floor = test::floorBelow(robot.kind == RobotKind::mav ? 1.2 : 0.0);
		const PointCloud obstacles = nearObstacles(frame, floor, robot, {}, {});
		const SightLines sight = sightLines(frame);
		AvoiderInput input = test::onFloor(obstacles, desired_rad);
		input.ground = floor;
		input.sight = &sight;
		input.sensor_in_robot = isometryOf(frame.robot_from_camera).translation();
		return avoid(input, robot, config);
	}
};

Scene hall()
{
	Scene scene;
	scene.floor(-2, -4, 20, 4).wall({-2, -4}, {20, -4}, 3.0).wall({-2, 4}, {20, 4}, 3.0);
	return scene;
}

TEST(UnseenSpace, DirectionsOutOfViewAreNotChosen)
{
	Scene scene = hall();
	scene.wall({1.5, -1.5}, {1.5, 1.5}, 2.5);  // fills the view; the way past it is beside
	Look look(scene);
	const Avoidance careful = look.avoidance();
	ASSERT_TRUE(careful.heading_rad);
	EXPECT_LE(std::abs(*careful.heading_rad), kHalfView);
	EXPECT_LE(careful.open_path_m, (1.5 - kHull_m) / std::cos(*careful.heading_rad) + 0.01);

	look.config.leave_out = AvoiderRemedy::unseen_blocks;
	const Avoidance careless = look.avoidance();
	ASSERT_TRUE(careless.heading_rad);
	EXPECT_GT(std::abs(*careless.heading_rad), kHalfView);
	EXPECT_DOUBLE_EQ(careless.open_path_m, 5.0);
}

TEST(UnseenSpace, AGoalOutOfViewIsApproachedAtTheEdgeOfTheView)
{
	for (const double side : {1.0, -1.0})
	{
		Look look(hall());
		look.desired_rad = side * 75 * kDegree_rad;
		const Avoidance result = look.avoidance();
		ASSERT_TRUE(result.heading_rad);
		EXPECT_GT(*result.heading_rad * side, 15 * kDegree_rad);
		EXPECT_LE(*result.heading_rad * side, kHalfView);
		EXPECT_EQ(result.turning_path_m, 0.0) << "it turns before it drives to where it has not looked";
	}
}

TEST(UnseenSpace, AHallLongerThanTheSensorsRangeIsFree)
{
	const Avoidance result = Look(hall(), kLowMount, {.max_depth_m = 8.0}).avoidance();
	ASSERT_TRUE(result.heading_rad);
	EXPECT_NEAR(*result.heading_rad, 0.0, 1e-9);
	EXPECT_GT(result.open_path_m, 4.9);
	EXPECT_GT(result.turning_path_m, 4.9);
}

TEST(UnseenSpace, TheBlindStretchBelowAHighLevelCameraDoesNotStopTheRobot)
{
	const CPose3D high(0.1, 0.0, 1.2, 0, 0, 0);
	const Avoidance result = Look(hall(), high, {.axial_scale = 1.0, .max_depth_m = 8.0}).avoidance();
	ASSERT_TRUE(result.heading_rad);
	EXPECT_NEAR(*result.heading_rad, 0.0, 1e-9);
	EXPECT_GT(result.open_path_m, 4.9);
}

TEST(UnseenSpace, WhatIsBlackIsNoWay)
{
	for (const double height : {0.3, 0.9})
	{
		Scene scene = hall();
		scene.box({2.2, 0.0, 0.5 * height}, {0.4, 0.8, height});
		Look look(scene);
		look.blackOut(hall());
		const Avoidance result = look.avoidance();
		ASSERT_TRUE(result.heading_rad);
		// The box begins at 2 m and reaches 0.4 m to both sides; a cell of the plan view is 0.07 m wide there.
		const double passes_at = 0.4 + kHull_m - 0.07;
		EXPECT_GT(2.0 * std::abs(std::tan(*result.heading_rad)), passes_at) << "box " << height << " m high";
	}
}

TEST(UnseenSpace, AWallTooNearToBeMeasuredIsNoWay)
{
	Scene scene = hall();
	scene.wall({0.45, -3}, {0.45, 3}, 2.5);
	const Avoidance result = Look(scene, kLowMount, {.min_depth_m = 0.5}).avoidance();
	EXPECT_LE(result.open_path_m, 0.45 - kHull_m);
}

TEST(UnseenSpace, SpecksWithoutReturnChangeNothing)
{
	const test::CameraNoise holes{.axial_scale = 1.0, .dropout_share = 0.3, .max_depth_m = 8.0};
	const Avoidance result = Look(hall(), kLowMount, holes).avoidance();
	ASSERT_TRUE(result.heading_rad);
	EXPECT_NEAR(*result.heading_rad, 0.0, 3 * kDegree_rad);
	EXPECT_GT(result.open_path_m, 4.5);
}

TEST(UnseenSpace, TheFarEndOfACorridorThatDoesNotAnswerAndTheImagesRimAreFree)
{
	Look look(test::corridorScene(12.0, {}, {}));
	DepthImage& image = look.frame.image;
	for (int v = 0; v < 240; ++v)
		for (int u = 0; u < 320; ++u)
		{
			float& depth = image.depth_m[static_cast<std::size_t>(v) * 320 + static_cast<std::size_t>(u)];
			const bool rim = u < 4 || v < 4 || u >= 316 || v >= 236;
			// Walls and floor are seen too flatly to answer from here on.
			if (rim || depth > 4.2F) depth = 0.0F;
		}
	const Avoidance result = look.avoidance();
	ASSERT_TRUE(result.heading_rad);
	EXPECT_NEAR(*result.heading_rad, 0.0, 1e-9);
	EXPECT_GT(result.open_path_m, 4.5);
	EXPECT_GT(result.turning_path_m, 4.5);
}

TEST(UnseenSpace, AMavClimbsOnlyWhereItLooks)
{
	// A wall that fills the view from the floor to far above; the open sky over it is out of the image.
	Scene scene = hall();
	scene.wall({3.0, -4}, {3.0, 4}, 2.6);
	Look look(scene, CPose3D(0.15, 0, 0, 0, 0, 0));
	look.frame = test::renderFrame(scene, CPose3D(0, 0, 1.2, 0, 0, 0), CPose3D(0.15, 0, 0, 0, 0, 0),
	                               test::xtionIntrinsics(320, 240), {});
	look.robot.kind = RobotKind::mav;
	look.robot.radius_m = 0.30;
	look.robot.height_m = 0.25;
	look.robot.max_altitude_m = 10.0;
	const Avoidance result = look.avoidance();
	ASSERT_TRUE(result.heading_rad);
	EXPECT_LE(std::abs(result.elevation_rad), 22.5 * kDegree_rad);
	EXPECT_LE(result.open_path_m, (3.0 - 0.30) / std::cos(*result.heading_rad) / std::cos(result.elevation_rad) + 0.02);
}

TEST(UnseenSpace, WithoutSightLinesUnseenIsFree)
{
	const PointCloud empty;
	AvoiderInput input = test::onFloor(empty, 2.0);
	const SightLines none;
	input.sight = &none;
	const Avoidance result = avoid(input, {}, {});
	ASSERT_TRUE(result.heading_rad);
	EXPECT_NEAR(*result.heading_rad, 2.0, 1e-9);
}

TEST(PaperAvoider, CropsObstaclesAndTrustsTheUnseen)
{
	// A wall 60° to the left of θ_d, and one across the way at 1.5 m.
	PointCloud cloud = test::wallCloud({1.5, -0.4}, {1.5, 0.1});
	cloud.push_back({0.2F, 0.26F, 0.3F});  // at 52°: touches the hull on every turn to the left
	AvoiderConfig config;
	config.method = AvoiderMethod::paper;
	const Avoidance paper = avoid(test::onFloor(cloud), {}, config);
	ASSERT_TRUE(paper.heading_rad);
	EXPECT_GT(*paper.heading_rad, 0.0) << "the shorter way past the wall, through what was cropped away";
	EXPECT_LT(*avoid(test::onFloor(cloud), {}, {}).heading_rad, 0.0);
}

TEST(LeftOutCorridor, EveryPointOfTheSectorCaps)
{
	PointCloud cloud;
	cloud.push_back({1.0F, 0.8F, 0.3F});   // 39° to the left: far beside the corridor, within the sector
	cloud.push_back({0.5F, -0.9F, 0.3F});  // 61° to the right: cropped
	AvoiderConfig config;
	config.leave_out = AvoiderRemedy::swept_corridor;
	const Avoidance result = avoid(test::onFloor(cloud), {}, config);
	ASSERT_TRUE(result.heading_rad);
	const double heading = *result.heading_rad;
	EXPECT_NEAR(result.open_path_m, std::abs(std::cos(heading) + 0.8 * std::sin(heading)) - kHull_m, 1e-5);
	EXPECT_DOUBLE_EQ(avoid(test::onFloor(cloud), {}, {}).open_path_m, 5.0);
}
}  // namespace
}  // namespace explore
