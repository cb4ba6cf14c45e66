#include <explore/core/geometry.h>
#include <explore/perception/perceive.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/analytic_scene.h"
#include "support/random_points.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;
/** The method whose stages these tests are about; full is tested in openings_test.cpp. */
PerceptionConfig paper()
{
	PerceptionConfig config;
	config.method = PerceptionMethod::paper;
	return config;
}

const CPose3D kMount(0.1, 0.0, 0.6, 0, 0, 0);

Percepts perceiveScene(const test::Scene& scene, const CPose3D& map_from_robot, const test::CameraNoise& noise,
                       const CPose3D& mount = kMount)
{
	return perceive(test::renderFrame(scene, map_from_robot, mount, test::xtionIntrinsics(), noise), paper());
}

/** A room with one wall at x = 3 that has a door of `width_m` around y = 0, and space behind. */
test::Scene frontalDoor(double width_m)
{
	test::Scene scene;
	scene.floor(-2, -4, 7, 4)
	    .wall({3, -4}, {3, 4}, 2.5, {{4 - 0.5 * width_m, width_m, 2.0}})
	    .wall({7, -4}, {7, 4}, 2.5);
	return scene;
}

TEST(Perceive, FrontalDoorUnderKinectNoise)
{
	for (std::uint32_t seed = 1; seed <= 5; ++seed)
	{
		const Percepts percepts =
		    perceiveScene(frontalDoor(1.0), {}, {.axial_scale = 1.0, .dropout_share = 0.02, .seed = seed});
		ASSERT_TRUE(percepts.ground);
		EXPECT_NEAR(percepts.ground->camera_height_m, 0.6, 0.02);
		ASSERT_EQ(percepts.doors.size(), 1U) << "seed " << seed;
		const Door& door = percepts.doors[0];
		EXPECT_LT((door.center.head<2>() - Eigen::Vector2d(3, 0)).norm(), 0.10);
		EXPECT_NEAR(door.center.z(), 1.0, 0.06);
		EXPECT_NEAR(door.width_m, 1.0, 0.10);
		EXPECT_LT((door.normal - Eigen::Vector3d(-1, 0, 0)).norm(), 0.05);
	}
}

TEST(Perceive, DoorSeenAtAnAngle)
{
	for (const double yaw_deg : {-20.0, 20.0})
	{
		const CPose3D map_from_robot(0.8, yaw_deg > 0 ? -1.2 : 1.2, 0, yaw_deg * kDegree_rad, 0, 0);
		const Percepts percepts = perceiveScene(frontalDoor(1.0), map_from_robot, {.axial_scale = 1.0});
		ASSERT_EQ(percepts.doors.size(), 1U) << yaw_deg;
		const auto& c = percepts.doors[0].center;
		double x = 0, y = 0, z = 0;
		map_from_robot.composePoint(c.x(), c.y(), c.z(), x, y, z);
		EXPECT_NEAR(x, 3.0, 0.10) << yaw_deg;
		EXPECT_NEAR(y, 0.0, 0.10) << yaw_deg;
	}
}

TEST(Perceive, PlainWallHasNoDoor)
{
	test::Scene scene;
	scene.floor(-2, -4, 7, 4).wall({3, -4}, {3, 4}, 2.5);
	const Percepts percepts = perceiveScene(scene, {}, {.axial_scale = 1.0, .dropout_share = 0.02});
	ASSERT_EQ(percepts.walls.size(), 1U);
	EXPECT_NEAR(percepts.walls[0].plane.signedDistance(Eigen::Vector3d(0.1, 0, 0.6)), 2.9, 0.02);
	EXPECT_TRUE(percepts.doors.empty());
}

TEST(Perceive, CorridorDirectionAndSideDoor)
{
	const test::Scene scene = test::corridorScene(9.0, {3.0}, {});
	for (const double yaw_deg : {-8.0, 0.0, 8.0})
	{
		const CPose3D map_from_robot(0, 0, 0, yaw_deg * kDegree_rad, 0, 0);
		const Percepts percepts = perceiveScene(scene, map_from_robot, {.axial_scale = 1.0});
		ASSERT_FALSE(percepts.vanishing_points.empty());
		EXPECT_NEAR(azimuthOf(percepts.vanishing_points[0].direction), -yaw_deg * kDegree_rad, 1.0 * kDegree_rad)
		    << yaw_deg;
		// Turned away from the left wall, less than alpha of the points lies on it: the paper's loop stops before it.
		if (yaw_deg < 0) continue;
		EXPECT_EQ(percepts.vanishing_points[0].walls.size(), 2U);
		ASSERT_EQ(percepts.doors.size(), 1U) << yaw_deg;
		const auto& c = percepts.doors[0].center;
		double x = 0, y = 0, z = 0;
		map_from_robot.composePoint(c.x(), c.y(), c.z(), x, y, z);
		EXPECT_LT(std::hypot(x - 3.45, y - 1.0), 0.15) << yaw_deg;
	}
}

TEST(Perceive, ObstaclesAreWhatIsNotGround)
{
	test::Scene scene = frontalDoor(1.0);
	scene.box({1.5, 0.5, 0.2}, {0.3, 0.3, 0.4});
	const Percepts percepts = perceiveScene(scene, {}, {});
	std::size_t on_box = 0, on_floor = 0;
	const PointCloud& obstacles = percepts.obstacles_in_robot;
	for (std::size_t i = 0; i < obstacles.size(); ++i)
	{
		if (obstacles.z[i] < 0.03F) ++on_floor;
		if (std::abs(obstacles.x[i] - 1.5F) < 0.2F && std::abs(obstacles.y[i] - 0.5F) < 0.2F) ++on_box;
	}
	EXPECT_EQ(on_floor, 0U);
	EXPECT_GT(on_box, 40U);
}

TEST(Perceive, FrameDoesNotDependOnTheMountThatDescribesIt)
{
	// The same image seen through a turned and tilted mount: results turn with the robot frame.
	const test::Scene scene = frontalDoor(1.0);
	const CPose3D tilted(0.2, 0.1, 0.9, 0, 12 * kDegree_rad, 4 * kDegree_rad);
	const Percepts percepts = perceiveScene(scene, {}, {.axial_scale = 1.0}, tilted);
	ASSERT_TRUE(percepts.ground);
	EXPECT_LT(angleBetweenAxes(percepts.ground->plane.normal, Eigen::Vector3d::UnitZ()), 1.0 * kDegree_rad);
	EXPECT_NEAR(percepts.ground->camera_height_m, 0.9, 0.02);
	ASSERT_EQ(percepts.doors.size(), 1U);
	EXPECT_LT((percepts.doors[0].center.head<2>() - Eigen::Vector2d(3, 0)).norm(), 0.10);
}

TEST(Perceive, UnorganisedCloudGivesWhatItsImageGives)
{
	const DepthFrame frame = test::renderFrame(frontalDoor(1.0), {}, kMount, test::xtionIntrinsics(),
	                                           {.axial_scale = 1.0, .max_depth_m = 4.0});
	DepthFrame cloud = frame;
	cloud.image = {};
	for (int v = 0; v < 480; ++v)
		for (int u = 0; u < 640; ++u)
			if (frame.image.at(u, v) > 0)
				cloud.points_in_camera.push_back(
				    (frame.image.at(u, v) * rayOfPixel(frame.image.intrinsics, u, v)).cast<float>());
	const Percepts a = perceive(frame, paper()), b = perceive(cloud, paper());
	ASSERT_EQ(a.doors.size(), 1U);
	ASSERT_EQ(b.doors.size(), 1U);
	EXPECT_LT((a.doors[0].center - b.doors[0].center).norm(), 0.05);
}

TEST(Perceive, SameSeedSameResultOtherSeedSameDoor)
{
	const DepthFrame frame = test::renderFrame(frontalDoor(1.0), {}, kMount, test::xtionIntrinsics(),
	                                           {.axial_scale = 1.0, .dropout_share = 0.05});
	const Percepts a = perceive(frame, paper()), b = perceive(frame, paper());
	ASSERT_EQ(a.walls.size(), b.walls.size());
	for (std::size_t i = 0; i < a.walls.size(); ++i) EXPECT_EQ(a.walls[i].plane.normal, b.walls[i].plane.normal);
	EXPECT_EQ(a.obstacles_in_robot.x, b.obstacles_in_robot.x);
	for (int seed = 2; seed < 12; ++seed)
	{
		PerceptionConfig config = paper();
		config.seed = seed;
		const Percepts other = perceive(frame, config);
		ASSERT_EQ(other.doors.size(), 1U) << "seed " << seed;
		EXPECT_LT((a.doors[0].center - other.doors[0].center).norm(), 0.06) << "seed " << seed;
	}
}

TEST(FilteredVoxels, EqualsTheTwoStagesOneAfterTheOther)
{
	std::mt19937 random(51);
	for (int run = 0; run < 10; ++run)
	{
		const CPose3D mount(test::uniform(random, -1, 1), 0.2, 0.7, test::uniform(random, -3, 3),
		                    test::uniform(random, -1, 1), test::uniform(random, -3, 3));
		DepthFrame frame = test::renderFrame(frontalDoor(1.0), {}, kMount, test::xtionIntrinsics(160, 120),
		                                     {.axial_scale = 1.0, .dropout_share = 0.05});
		frame.robot_from_camera = mount;
		const PointCloud fused = filteredVoxels(frame, {}, {});
		const PointCloud staged = voxelGrid(rangeFilter(frame, {}), {});
		ASSERT_GT(staged.size(), 1000U);
		EXPECT_EQ(fused.x, staged.x);
		EXPECT_EQ(fused.y, staged.y);
		EXPECT_EQ(fused.z, staged.z);
	}
}

TEST(Perceive, DarkFrameFindsNothing)
{
	DepthFrame frame;
	frame.image.intrinsics = test::xtionIntrinsics(64, 48);
	frame.image.depth_m.assign(64 * 48, 0.0F);
	const Percepts percepts = perceive(frame, paper());
	EXPECT_FALSE(percepts.ground);
	EXPECT_TRUE(percepts.walls.empty() && percepts.doors.empty() && percepts.vanishing_points.empty());
	EXPECT_EQ(percepts.near_field.valid_pixels, 0U);
	EXPECT_TRUE(perceive(DepthFrame{}, paper()).obstacles_in_robot.empty());
}
}  // namespace
}  // namespace explore
