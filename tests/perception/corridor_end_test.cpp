#include <explore/core/geometry.h>
#include <explore/perception/corridor_end.h>
#include <gtest/gtest.h>

#include <random>

#include "corridor_views.h"

namespace explore::test
{
namespace
{
std::vector<CorridorEnd> endsOf(const CorridorView& view, const std::vector<UprightWall>& walls)
{
	return findCorridorEnds(corridorPairs(view.level, walls, {}, {}), {});
}

/** A corridor that ends at x = `end_m` in a hall of 8 m × 4 m. */
Scene corridorIntoHall(double width_m, double end_m)
{
	Scene scene = sideWalls(width_m, end_m);
	const double side = 0.5 * width_m;
	scene.wall({end_m, side}, {end_m, 4}, 2.6).wall({end_m, -4}, {end_m, -side}, 2.6);
	scene.wall({end_m, 4}, {end_m + 4, 4}, 2.6).wall({end_m, -4}, {end_m + 4, -4}, 2.6);
	return scene.wall({end_m + 4, -4}, {end_m + 4, 4}, 2.6);
}

TEST(CorridorEnd, IsPlacedAtTheWallsEnds)
{
	std::mt19937 random(7);
	for (std::uint32_t run = 0; run < 12; ++run)
	{
		const double width = uniform(random, 1.0, 2.4), end = uniform(random, 1.5 * width + 0.3, 4.7);
		const CameraPlace place{0,
		                        uniform(random, -0.15, 0.15) * width,
		                        uniform(random, 0.4, 1.4),
		                        uniform(random, -6, 6) * kDegree_rad,
		                        uniform(random, -6, 6) * kDegree_rad,
		                        uniform(random, -10, 10) * kDegree_rad};
		const auto view = viewOf(corridorIntoHall(width, end), place, sensorNoise(run));
		const auto ends = endsOf(*view, bothWalls(*view, width, width, end, 0.5 * kDegree_rad, -0.5 * kDegree_rad));
		ASSERT_EQ(ends.size(), 1U) << run;
		EXPECT_LT((view->toMap(ends[0].center) - Eigen::Vector2d(end, 0)).norm(), 0.06) << run;
		EXPECT_NEAR(ends[0].width_m, width, 0.05) << run;
		EXPECT_NEAR(ends[0].clear_width_m, width, 0.15) << run;
		EXPECT_GT(-ends[0].normal.dot(ends[0].center.normalized()), 0.8) << "toward the camera";
		EXPECT_GT(ends[0].through, 0.8) << run;
	}
}

TEST(CorridorEnd, AHallOutOfRangeIsKnownByItsFloor)
{
	const auto view = viewOf(corridorIntoHall(1.6, 3.0), {0, 0, 1.2, 0, 8 * kDegree_rad}, sensorNoise(1, 5.0));
	const auto ends = endsOf(*view, bothWalls(*view, 1.6, 1.5, 3.0));
	ASSERT_EQ(ends.size(), 1U);
	EXPECT_LT((view->toMap(ends[0].center) - Eigen::Vector2d(3, 0)).norm(), 0.05);
	EXPECT_GT(ends[0].no_return, 0.3);
	EXPECT_GT(ends[0].left_floor, 50);
}

TEST(CorridorEnd, ADarkOpeningWithoutAnythingBehindIsNotPromised)
{
	Scene scene;  // both walls end at 3 m, and nothing at all returns from behind
	scene.floor(-4, -2, 3, 2).wall({-2, 0.8}, {3, 0.8}, 2.6).wall({-2, -0.8}, {3, -0.8}, 2.6);
	const auto view = viewOf(scene, {}, sensorNoise(1));
	EXPECT_TRUE(endsOf(*view, bothWalls(*view, 1.6, 1.5, 3.0)).empty());
}

TEST(CorridorEnd, ADeadEndIsNone)
{
	const Scene scene = sideWalls(1.8, 4).wall({4, -0.9}, {4, 0.9}, 2.6);
	const auto view = viewOf(scene, {}, sensorNoise(1));
	auto walls = bothWalls(*view, 1.8, 1.7, 4);
	walls.push_back(view->wall({4, -0.9}, {4, 0.9}));
	EXPECT_TRUE(endsOf(*view, walls).empty());
}

TEST(CorridorEnd, ACorridorThatGoesOnIsNone)
{
	const auto view = viewOf(sideWalls(1.8, 14), {}, sensorNoise(1));
	EXPECT_TRUE(endsOf(*view, bothWalls(*view, 1.8, 1.7, 5)).empty());
}

TEST(CorridorEnd, DoorsOppositeEachOtherAreNone)
{
	// Doors from x = 3.0 to 4.0 on both sides, rooms behind them.
	Scene scene = sideWalls(1.6, 14, {{5, 1.0, 2.0}}, {{5, 1.0, 2.0}});
	scene.wall({-2, 4}, {14, 4}, 2.6).wall({-2, -4}, {14, -4}, 2.6);
	for (std::uint32_t run = 0; run < 4; ++run)
	{
		const auto view = viewOf(scene, {0, 0, 0.6, (4.0 * run - 6.0) * kDegree_rad}, sensorNoise(run));
		EXPECT_TRUE(endsOf(*view, bothWalls(*view, 1.6, 1.5, 5)).empty()) << run;
	}
}

TEST(CorridorEnd, WhereOneWallEndsThereIsNone)
{
	Scene scene;
	scene.floor(-4, -9, 16, 9)
	    .wall({-2, 0.8}, {3, 0.8}, 2.6)
	    .wall({-2, -0.8}, {9, -0.8}, 2.6)
	    .wall({9, -5}, {9, 5}, 2.6);
	const auto view = viewOf(scene, {}, sensorNoise(1));
	EXPECT_TRUE(endsOf(*view, {view->wall({1.5, 0.8}, {3, 0.8}), view->wall({1.5, -0.8}, {5, -0.8})}).empty());
}

TEST(CorridorEnd, ACorridorThatWidensALittleIsNone)
{
	// The walls step back by 0.2 m at x = 3.
	Scene scene = sideWalls(1.6, 3.0);
	for (const double side : {-1.0, 1.0})
		scene.wall({3, 0.8 * side}, {3, 1.0 * side}, 2.6).wall({3, 1.0 * side}, {14, 1.0 * side}, 2.6);
	const auto view = viewOf(scene, {}, sensorNoise(1));
	EXPECT_TRUE(endsOf(*view, bothWalls(*view, 1.6, 1.5, 3.0)).empty());
}

TEST(CorridorEnd, TheJambsOfADoorAreNone)
{
	// A wall 0.3 m thick with an opening of 1.4 m, seen from the room before it.
	Scene scene;
	scene.floor(-4, -9, 16, 9).wall({8, -5}, {8, 5}, 2.6);
	for (const double side : {-1.0, 1.0})
		scene.wall({2.5, 0.7 * side}, {2.5, 4 * side}, 2.6).wall({2.5, 0.7 * side}, {2.8, 0.7 * side}, 2.6);
	const auto view = viewOf(scene, {}, sensorNoise(1));
	EXPECT_TRUE(endsOf(*view, bothWalls(*view, 1.4, 2.5, 2.8)).empty());
}

TEST(CorridorEnd, WhatStandsInItLeavesLessClearWidth)
{
	Scene scene = corridorIntoHall(2.0, 3.2);
	scene.box({3.3, 0.6, 0.6}, {0.5, 0.5, 1.2});  // from y = 0.35 to 0.85
	const auto view = viewOf(scene, {}, sensorNoise(1));
	const auto ends = endsOf(*view, bothWalls(*view, 2.0, 1.9, 3.2));
	ASSERT_EQ(ends.size(), 1U);
	EXPECT_NEAR(ends[0].width_m, 2.0, 0.05);
	EXPECT_NEAR(ends[0].clear_width_m, 1.35, 0.12);
}
}  // namespace
}  // namespace explore::test
