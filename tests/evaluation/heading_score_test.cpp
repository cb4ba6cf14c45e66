#include "evaluation/truth_maker.h"

#include <explore/core/geometry.h>
#include <explore/evaluation/heading_score.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace explore;
using namespace explore::evaluation;

namespace
{
const CameraIntrinsics kCamera{640, 480, 588.0, 588.0, 319.5, 239.5};  // ±28.5°, ±22.1°

Decision driving(double chosen_deg, double desired_deg, double speed_mps = 0.5)
{
	Decision decision;
	decision.headings.desired_rad = desired_deg * kDegree_rad;
	decision.headings.chosen_rad = chosen_deg * kDegree_rad;
	decision.command.velocity_mps.x() = speed_mps;
	return decision;
}

Decision stopped()
{
	Decision decision;
	decision.headings.desired_rad = 0.0;
	decision.stop = true;
	return decision;
}

void setFree(TruthFreePaths& paths, int degree, float free_m, std::size_t elevation = 0)
{
	paths.free_m[elevation * 360 + static_cast<std::size_t>((degree + 360) % 360)] = free_m;
}

HeadingScore score(const Decision& decision, const TruthFreePaths& paths, const mrpt::poses::CPose3D& pose = {},
                   const mrpt::poses::CPose3D& camera = {})
{
	return scoreHeading(decision, {paths, pose, camera, kCamera}, RobotConfig(), HeadingConfig());
}
}  // namespace

TEST(HeadingScore, StraightOnInFreeSpaceIsBest)
{
	const auto result = score(driving(0, 0), test::evenPaths(8));
	EXPECT_DOUBLE_EQ(result.best, 5.0);
	EXPECT_DOUBLE_EQ(*result.chosen, 5.0);
	EXPECT_TRUE(result.good);
	EXPECT_FALSE(result.collision);
}

TEST(HeadingScore, NineTenthsOfTheBestAreGood)
{
	const auto paths = test::evenPaths(8);
	EXPECT_TRUE(score(driving(25, 0), paths).good);   // cos 25° = 0.906
	EXPECT_FALSE(score(driving(27, 0), paths).good);  // cos 27° = 0.891
	EXPECT_TRUE(score(driving(-25, 0), paths).good);
}

TEST(HeadingScore, TheWayRoundAnObstacleIsGoodAndIntoItIsACollision)
{
	auto paths = test::evenPaths(4);
	for (int degree = -10; degree <= 10; ++degree) setFree(paths, degree, 0.3F);
	const auto round = score(driving(12, 0), paths);
	EXPECT_NEAR(round.best, 4 * std::cos(11 * kDegree_rad), 1e-6);
	EXPECT_TRUE(round.good);
	EXPECT_FALSE(round.collision);
	const auto into = score(driving(5, 0), paths);
	EXPECT_FALSE(into.good);
	EXPECT_TRUE(into.collision);                               // 0.5²/(2·0.5) + 0.5·0.3 + 0.1 = 0.5 m are needed
	EXPECT_FALSE(score(driving(5, 0, 0.1), paths).collision);  // slow: 0.14 m are enough
}

TEST(HeadingScore, WhatTheCameraDoesNotSeeIsNoReproach)
{
	auto paths = test::evenPaths(1);
	for (int degree = 35; degree <= 90; ++degree) setFree(paths, degree, 8.0F);
	EXPECT_NEAR(score(driving(0, 0), paths).best, 1.0, 1e-9);
	EXPECT_TRUE(score(driving(0, 0), paths).good);
	const mrpt::poses::CPose3D looks_left(0, 0, 0, 60 * kDegree_rad, 0, 0);
	EXPECT_GT(score(driving(0, 0), paths, {}, looks_left).best, 3.5);
	// The robot's own heading does not matter: azimuths count from it.
	EXPECT_NEAR(score(driving(0, 0), paths, mrpt::poses::CPose3D(1, 2, 0, 2.5, 0, 0)).best, 1.0, 1e-9);
}

TEST(HeadingScore, AStopIsGoodWhereNoWayIsLongerThanTheStoppingDistance)
{
	auto paths = test::evenPaths(0.4F);
	EXPECT_TRUE(score(stopped(), paths).good);
	EXPECT_FALSE(score(stopped(), paths).chosen);
	setFree(paths, 60, 5.0F);
	EXPECT_TRUE(score(stopped(), paths).good);  // out of view
	setFree(paths, -20, 0.6F);
	EXPECT_FALSE(score(stopped(), paths).good);
	EXPECT_FALSE(score(stopped(), paths).collision);
}

TEST(HeadingScore, AMavMayClimbOverAnObstacle)
{
	auto paths = test::evenPaths(0.5F, {-20 * kDegree_rad, 0, 20 * kDegree_rad});
	for (int degree = 0; degree < 360; ++degree) setFree(paths, degree, 4.0F, 2);
	auto decision = driving(0, 0);
	EXPECT_FALSE(score(decision, paths).good);
	EXPECT_NEAR(score(decision, paths).best, 4 * std::cos(20 * kDegree_rad), 1e-6);
	decision.headings.chosen_elevation_rad = 19 * kDegree_rad;
	EXPECT_TRUE(score(decision, paths).good);
	// A camera that looks down does not see the way up.
	const mrpt::poses::CPose3D looks_down(0, 0, 0, 0, 20 * kDegree_rad, 0);
	EXPECT_NEAR(score(decision, paths, {}, looks_down).best, 0.5, 1e-6);
}
