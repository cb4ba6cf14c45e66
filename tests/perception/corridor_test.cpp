#include <explore/core/geometry.h>
#include <explore/perception/corridor.h>
#include <gtest/gtest.h>

#include <random>

#include "corridor_views.h"

namespace explore::test
{
namespace
{
std::optional<CorridorSeen> seen(const CorridorView& view, const std::vector<UprightWall>& walls,
                                 const CorridorConfig& config = {})
{
	return findCorridor(corridorPairs(view.level, walls, config.pairs, {}), config);
}

/** Degrees between the corridor's direction and the map's x axis, along which it was built. */
double errorOf(const CorridorSeen& corridor, const CorridorView& view)
{
	const Eigen::Vector2d in_map = view.level_from_map.linear().transpose() * corridor.direction;
	return std::atan2(std::abs(in_map.y()), in_map.x()) / kDegree_rad;
}

TEST(Corridor, DirectionIsBetterThanThatOfItsWalls)
{
	std::mt19937 random(5);
	for (std::uint32_t run = 0; run < 12; ++run)
	{
		const double width = uniform(random, 1.0, 2.2);
		const CameraPlace place{0,
		                        uniform(random, -0.2, 0.2) * width,
		                        uniform(random, 0.4, 1.6),
		                        uniform(random, -15, 15) * kDegree_rad,
		                        uniform(random, -8, 8) * kDegree_rad,
		                        uniform(random, -10, 10) * kDegree_rad};
		const Scene scene = sideWalls(width, 14, {{5.0, 0.9, 2.0}}, {{6.2, 1.0, 2.0}});
		const auto view = viewOf(scene, place, sensorNoise(run));
		const auto walls = bothWalls(*view, width, 2.5, 5, uniform(random, -1.5, 1.5) * kDegree_rad,
		                             uniform(random, -1.5, 1.5) * kDegree_rad);
		const auto corridor = seen(*view, walls);
		ASSERT_TRUE(corridor) << run;
		EXPECT_LT(errorOf(*corridor, *view), 0.25) << run;
		EXPECT_NEAR(corridor->width_m, width, 0.02) << run;
		EXPECT_NEAR(corridor->offset_m, place.y_m, 0.02) << run;
		EXPECT_EQ(corridor->walls, (std::vector<std::size_t>{0, 1}));
		EXPECT_GT(corridor->to_m, 5.0) << "points beyond the found walls count too";
	}
}

TEST(Corridor, AThirdWallThatIsAskewDoesNotPullIt)
{
	Scene scene = sideWalls(2.0, 14);
	scene.wall({2.5, 0.7}, {4.0, 0.7 - 1.5 * std::tan(5 * kDegree_rad)}, 1.2);  // cupboards, not quite along the wall
	const auto view = viewOf(scene, {}, sensorNoise(1));
	auto walls = bothWalls(*view, 2.0, 2, 5);
	walls.push_back(view->wall({2.5, 0.7}, {4.0, 0.7 - 1.5 * std::tan(5 * kDegree_rad)}));
	const auto corridor = seen(*view, walls);
	ASSERT_TRUE(corridor);
	EXPECT_LT(errorOf(*corridor, *view), 0.2);
	EXPECT_EQ(corridor->walls, (std::vector<std::size_t>{0, 1}));
}

TEST(Corridor, ParallelCupboardsVoteForIt)
{
	Scene scene = sideWalls(2.4, 14);
	scene.box({3.5, 1.0, 0.5}, {1.5, 0.4, 1.0});
	const auto view = viewOf(scene, {}, sensorNoise(1));
	auto walls = bothWalls(*view, 2.4, 2.5, 5);
	walls.push_back(view->wall({2.75, 0.8}, {4.25, 0.8}));
	const auto corridor = seen(*view, walls);
	ASSERT_TRUE(corridor);
	EXPECT_LT(errorOf(*corridor, *view), 0.2);
	EXPECT_EQ(corridor->walls, (std::vector<std::size_t>{0, 1, 2}));
	EXPECT_NEAR(corridor->width_m, 2.4, 0.02) << "the longer stretch is that between the walls";
}

TEST(Corridor, TheFarWallOfAYawedViewIsFoundFromTheNearOne)
{
	// 18° off: only the left wall is within the range in which walls are looked for.
	const auto view = viewOf(sideWalls(1.6, 14), {0, 0.2, 0.6, 18 * kDegree_rad}, sensorNoise(2));
	const auto corridor = seen(*view, {view->wall({0.6, 0.8}, {4.8, 0.8})});
	ASSERT_TRUE(corridor);
	EXPECT_LT(errorOf(*corridor, *view), 0.3);
	EXPECT_NEAR(corridor->width_m, 1.6, 0.03);
	EXPECT_EQ(corridor->walls, (std::vector<std::size_t>{0}));
}

TEST(Corridor, OneWallIsNone)
{
	Scene scene;
	scene.floor(-4, -9, 16, 9).wall({-2, 1}, {14, 1}, 2.6).wall({6, -6}, {6, 1}, 2.6);
	const auto view = viewOf(scene, {});
	EXPECT_FALSE(seen(*view, {view->wall({2, 1}, {6, 1}), view->wall({6, -6}, {6, 1})}));
	EXPECT_FALSE(seen(*view, {}));
}

TEST(Corridor, ARoomAsLongAsWideIsNone)
{
	for (const double width : {2.6, 3.8, 5.0})
	{
		const double far = 1.1 * width + 1.0;
		const Scene scene = sideWalls(width, far).wall({far, -0.5 * width}, {far, 0.5 * width}, 2.6);
		const auto view = viewOf(scene, {});
		auto walls = bothWalls(*view, width, width, far);
		walls.push_back(view->wall({far, -0.5 * width}, {far, 0.5 * width}));
		EXPECT_FALSE(seen(*view, walls)) << width;
	}
}

TEST(Corridor, WallsTooFarApartAreNone)
{
	const auto view = viewOf(sideWalls(4.6, 16), {});
	EXPECT_FALSE(seen(*view, bothWalls(*view, 4.6, 4.5, 6)));
}

TEST(Corridor, AWardrobeOppositeAWallIsNone)
{
	Scene scene;
	scene.floor(-4, -9, 16, 9).wall({-2, 1}, {8, 1}, 2.6).wall({8, -5}, {8, 1}, 2.6).wall({-2, -5}, {8, -5}, 2.6);
	scene.box({3.5, -1.3, 1.0}, {1.8, 0.6, 2.0});
	const auto view = viewOf(scene, {}, sensorNoise(3));
	EXPECT_FALSE(seen(*view, {view->wall({2, 1}, {5, 1}), view->wall({2.6, -1}, {4.4, -1})}));
}

TEST(Corridor, OneBehindADoorIsNotTheRobots)
{
	Scene scene;
	scene.floor(-4, -9, 16, 9).wall({2.5, -4}, {2.5, 4}, 2.6, {{3.5, 1.0, 2.0}});
	scene.wall({2.5, 0.7}, {14, 0.7}, 2.6).wall({2.5, -0.7}, {14, -0.7}, 2.6);
	const auto view = viewOf(scene, {-1.5});
	auto walls = bothWalls(*view, 1.4, 2.7, 4);
	EXPECT_TRUE(seen(*view, walls));
	walls.push_back(view->wall({2.5, -4}, {2.5, 4}));
	EXPECT_FALSE(seen(*view, walls));
}

TEST(Corridor, SideDoorsDoNotInterruptItAndAHallEndsIt)
{
	// Doors from x = 3.2 to 4.4 on both sides; and walls that end at 3.2.
	const auto doors = viewOf(sideWalls(1.4, 14, {{5.2, 1.2, 2.0}}, {{5.2, 1.2, 2.0}}), {});
	const auto corridor = seen(*doors, bothWalls(*doors, 1.4, 1.4, 5));
	ASSERT_TRUE(corridor);
	EXPECT_GT(corridor->to_m, 5.0);
	const auto hall = viewOf(sideWalls(1.4, 3.2).wall({7, -6}, {7, 6}, 2.6), {});
	EXPECT_FALSE(seen(*hall, bothWalls(*hall, 1.4, 1.4, 3.2)));
}

TEST(Corridor, ThePapersWayTakesTheLargestGroupAndNeverAbstains)
{
	CorridorConfig config;
	config.vote = false;
	Scene scene;
	scene.floor(-4, -9, 16, 9).wall({-2, 1}, {5, 1}, 2.6).wall({5, -6}, {5, 1}, 2.6);
	const auto view = viewOf(scene, {});
	const UprightWall side = view->wall({2, 1}, {5, 1}), end = view->wall({5, -2}, {5, 1});
	UprightWall smaller = end;
	smaller.samples = side.samples / 2;
	const auto corridor = seen(*view, {smaller, side}, config);
	ASSERT_TRUE(corridor);
	EXPECT_EQ(corridor->walls, (std::vector<std::size_t>{1}));
	EXPECT_LT(errorOf(*corridor, *view), 1e-6);
	EXPECT_NEAR(corridor->point.norm(), 5.0, 1e-6) << "as far as the walls are seen";
	EXPECT_FALSE(seen(*view, {}, config));
}

TEST(Corridor, VanishingPointIsInTheRobotFrameAtTheCamerasHeight)
{
	LevelPose pose;
	pose.level_from_camera.translation() = Eigen::Vector3d(0, 0, 0.7);
	pose.robot_from_level.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
	pose.robot_from_level.translation() = Eigen::Vector3d(0.1, 0, -0.02);
	CorridorSeen corridor;
	corridor.direction = {std::cos(0.2), std::sin(0.2)};
	corridor.point = 4.0 * corridor.direction;
	corridor.walls = {0, 2};
	corridor.samples = 77;
	const VanishingPoint point = vanishingPointOf(corridor, pose);
	EXPECT_NEAR(azimuthOf(point.direction), 0.5, 1e-9);
	EXPECT_LT((point.point - Eigen::Vector3d(0.1 + 4 * std::cos(0.5), 4 * std::sin(0.5), 0.68)).norm(), 1e-9);
	EXPECT_EQ(point.walls, (std::vector<std::size_t>{0, 2}));
	EXPECT_EQ(point.inliers, 77U);
}
}  // namespace
}  // namespace explore::test
