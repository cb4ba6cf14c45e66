#include <explore/core/geometry.h>
#include <explore/navigation/avoider.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "obstacle_scenes.h"

namespace explore
{
namespace
{
using test::addWall;
using test::evenClearance;
using test::floorBelow;
using test::onFloor;
using test::randomCloud;
using test::wallCloud;

/** Every point of the swept disc, written out once more. */
double openTo(const PointCloud& cloud, double azimuth, double radius, double range)
{
	double open = range;
	for (std::size_t i = 0; i < cloud.size(); ++i)
	{
		const double x = cloud.x[i], y = cloud.y[i];
		const double ahead = x * std::cos(azimuth) + y * std::sin(azimuth);
		const double aside = y * std::cos(azimuth) - x * std::sin(azimuth);
		if (ahead <= 0.0 || std::abs(aside) >= radius) continue;
		open = std::min(open, std::max(0.0, ahead - std::sqrt(radius * radius - aside * aside)));
	}
	return open;
}

TEST(Avoider, KeepsTheDesiredDirectionInFreeSpace)
{
	const PointCloud cloud;
	for (const double desired : {0.0, 0.3, -1.2, 3.1})
	{
		const Avoidance result = avoid(onFloor(cloud, desired), RobotConfig(), evenClearance());
		ASSERT_TRUE(result.heading_rad);
		EXPECT_NEAR(*result.heading_rad, desired, 1e-12);
		EXPECT_FALSE(result.deviates);
		EXPECT_DOUBLE_EQ(result.open_path_m, 5.0);
		EXPECT_DOUBLE_EQ(result.turning_path_m, 5.0);
	}
}

TEST(Avoider, PassesABoxOnTheFreerSideOfACorridor)
{
	for (const double side : {1.0, -1.0})
	{
		PointCloud cloud;
		addWall(cloud, {0.5, -1.2}, {5.0, -1.2});
		addWall(cloud, {0.5, 1.2}, {5.0, 1.2});
		addWall(cloud, {2.0, side * 0.5}, {2.0, side * -0.1});  // box front; the other side is wider
		const Avoidance result = avoid(onFloor(cloud), RobotConfig(), evenClearance());
		ASSERT_TRUE(result.heading_rad);
		EXPECT_TRUE(result.deviates);
		EXPECT_LT(*result.heading_rad * side, 0.0);
		EXPECT_GT(result.open_path_m, 2.0) << "past the box";
		EXPECT_NEAR(result.open_path_m, openTo(cloud, *result.heading_rad, 0.27, 5.0), 1e-6);
	}
}

TEST(Avoider, ScoreIsTheMaximumOverTheCandidates)
{
	std::mt19937 random(3);
	std::uniform_real_distribution<double> angle(-3.1, 3.1);
	const AvoiderConfig config = evenClearance();
	RobotConfig robot;
	robot.height_m = 20.0;
	int deviations = 0;
	for (int trial = 0; trial < 200; ++trial)
	{
		const PointCloud cloud = randomCloud(random, 10 + trial, 5.0);
		AvoiderInput input = onFloor(cloud, angle(random));
		input.ground = floorBelow(10.0);
		const Avoidance result = avoid(input, robot, config);
		double best = 0.0;
		for (int k = -90; k <= 90; ++k)
			best = std::max(best, openTo(cloud, input.desired_rad + 0.5 * k * kDegree_rad, 0.27, 5.0) *
			                          std::cos(0.5 * k * kDegree_rad));
		if (best == 0.0)
		{
			EXPECT_FALSE(result.heading_rad);
			continue;
		}
		ASSERT_TRUE(result.heading_rad);
		const double turn = wrapToPi(*result.heading_rad - input.desired_rad);
		EXPECT_NEAR(std::remainder(turn, 0.5 * kDegree_rad), 0.0, 1e-9);
		EXPECT_LE(std::abs(turn), 45 * kDegree_rad + 1e-9);
		const double score = openTo(cloud, *result.heading_rad, 0.27, 5.0) * std::cos(turn);
		// A steadier direction, or the side that the robot faces, may be worth 3 % less.
		EXPECT_GE(score, best * 0.97 - 1e-6) << "trial " << trial;
		EXPECT_NEAR(result.open_path_m * std::cos(turn), score, 1e-6);
		deviations += result.deviates ? 1 : 0;
	}
	EXPECT_GT(deviations, 100);
}

TEST(Avoider, SymmetricObstacleIsPassedOnTheLeftAndAlwaysTheSame)
{
	const PointCloud cloud = wallCloud({2.0, -0.3}, {2.0, 0.3});
	const Avoidance first = avoid(onFloor(cloud), RobotConfig(), evenClearance());
	ASSERT_TRUE(first.heading_rad);
	EXPECT_GT(*first.heading_rad, 0.0);
	EXPECT_TRUE(first.deviates);
	for (int i = 0; i < 3; ++i)
		EXPECT_EQ(avoid(onFloor(cloud), RobotConfig(), evenClearance()).heading_rad, first.heading_rad);
}

TEST(Avoider, StaysOnTheSideItHasTurnedTo)
{
	// The goal lies behind the middle of an obstacle, and the robot has already turned 10° to one side of it.
	for (const double side : {1.0, -1.0})
	{
		PointCloud cloud;
		const Eigen::Rotation2Dd turned(-side * 10 * kDegree_rad);
		addWall(cloud, turned * Eigen::Vector2d(2.0, -0.3), turned * Eigen::Vector2d(2.0, 0.3));
		const Avoidance result = avoid(onFloor(cloud, -side * 10 * kDegree_rad), RobotConfig(), evenClearance());
		ASSERT_TRUE(result.heading_rad);
		EXPECT_GT(*result.heading_rad * side, 0.0);
	}
}

TEST(Avoider, AWayThatIsFreeUpToTheGoalIsNotLeft)
{
	const PointCloud cloud = wallCloud({3.0, -1.0}, {3.0, 0.6});
	AvoiderInput input = onFloor(cloud);
	EXPECT_TRUE(avoid(input, RobotConfig(), evenClearance()).deviates);
	input.goal_distance_m = 2.4;
	const Avoidance result = avoid(input, RobotConfig(), evenClearance());
	EXPECT_FALSE(result.deviates);
	EXPECT_NEAR(result.open_path_m, 3.0 - 0.27, 1e-3) << "reported beyond the goal, for the speed";
}

TEST(Avoider, WithoutAWayThereIsNoHeading)
{
	PointCloud cloud;
	for (int i = -90; i <= 90; ++i)
		cloud.push_back({static_cast<float>(0.25 * std::cos(i * kDegree_rad)),
		                 static_cast<float>(0.25 * std::sin(i * kDegree_rad)), 0.3F});
	const Avoidance result = avoid(onFloor(cloud), RobotConfig(), evenClearance());
	EXPECT_FALSE(result.heading_rad);
	EXPECT_EQ(result.open_path_m, 0.0);
}

TEST(Avoider, ObstacleBesideTheRobotCountsThoughTheSectorEndsBeforeIt)
{
	// At 100° to the left, touching the hull's way on every turn to that side; the paper's crop at ±45° would drop it.
	PointCloud cloud = wallCloud({1.5, -0.4}, {1.5, 0.1});
	cloud.push_back({0.2F, 0.26F, 0.3F});
	const Avoidance result = avoid(onFloor(cloud), RobotConfig(), evenClearance());
	ASSERT_TRUE(result.heading_rad);
	EXPECT_LE(*result.heading_rad, 0.0);
	EXPECT_GT(result.open_path_m, 0.5);
}

TEST(Avoider, TurningPathIsTheLeastOnTheWayToTheHeading)
{
	const PointCloud cloud = wallCloud({1.0, -0.3}, {1.0, 0.3});
	const Avoidance result = avoid(onFloor(cloud), RobotConfig(), evenClearance());
	ASSERT_TRUE(result.heading_rad);
	EXPECT_NEAR(result.turning_path_m, 1.0 - 0.27, 1e-3);
	EXPECT_GT(result.open_path_m, 4.0);
}

TEST(Avoider, MavClimbsOverAWall)
{
	// A wall across the way from the floor to 0.30 m above the body's centre, a free sky above it.
	PointCloud cloud;
	for (int i = -200; i <= 200; ++i)
		for (double z = -1.0; z < 0.31; z += 0.05)
			cloud.push_back({2.5F, 0.02F * static_cast<float>(i), static_cast<float>(z)});
	RobotConfig robot;
	robot.kind = RobotKind::mav;
	robot.radius_m = 0.30;
	robot.height_m = 0.25;
	robot.max_altitude_m = 4.0;
	AvoiderInput input = onFloor(cloud);
	input.ground = floorBelow(1.0);
	const Avoidance result = avoid(input, robot, evenClearance());
	ASSERT_TRUE(result.heading_rad);
	EXPECT_NEAR(*result.heading_rad, 0.0, 1e-12);
	EXPECT_NEAR(result.elevation_rad, 20 * kDegree_rad, 1e-9);
	EXPECT_TRUE(result.deviates);
	EXPECT_DOUBLE_EQ(result.open_path_m, 5.0);

	input.ground.reset();
	EXPECT_EQ(avoid(input, robot, evenClearance()).elevation_rad, 0.0) << "no altitude is known";
}

TEST(Avoider, GroundRobotNeverClimbs)
{
	const PointCloud cloud = wallCloud({2.0, -3.0}, {2.0, 3.0});
	AvoiderInput input = onFloor(cloud);
	input.desired_elevation_rad = 0.4;
	const Avoidance result = avoid(input, RobotConfig(), evenClearance());
	EXPECT_EQ(result.elevation_rad, 0.0);
	ASSERT_TRUE(result.heading_rad);
}
}  // namespace
}  // namespace explore
