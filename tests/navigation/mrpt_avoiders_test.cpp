#include <explore/navigation/avoider.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "obstacle_scenes.h"

namespace explore
{
namespace
{
using test::onFloor;
using test::randomCloud;
using test::wallCloud;

class MrptAvoider : public testing::TestWithParam<AvoiderMethod>
{
protected:
	static Avoidance run(const AvoiderInput& input)
	{
		AvoiderConfig config = test::evenClearance();
		config.method = GetParam();
		return avoid(input, RobotConfig(), config);
	}
};

TEST_P(MrptAvoider, GoesStraightInFreeSpaceWhateverTheDirection)
{
	const PointCloud empty;
	for (const double desired : {0.0, 0.7, -2.0, 3.1, -3.1})
	{
		const Avoidance result = run(onFloor(empty, desired));
		ASSERT_TRUE(result.heading_rad) << desired;
		EXPECT_NEAR(*result.heading_rad, desired, 1e-9);
		EXPECT_FALSE(result.deviates);
		EXPECT_DOUBLE_EQ(result.open_path_m, 5.0);
	}
}

TEST_P(MrptAvoider, HasNoHeadingWhenShutIn)
{
	PointCloud cloud;
	for (int i = 0; i < 360; ++i)
	{
		const double angle = i * std::numbers::pi / 180.0;
		cloud.push_back({static_cast<float>(0.26 * std::cos(angle)), static_cast<float>(0.26 * std::sin(angle)), 0.3F});
	}
	const Avoidance result = run(onFloor(cloud));
	EXPECT_FALSE(result.heading_rad);
	EXPECT_EQ(result.open_path_m, 0.0);
}

TEST_P(MrptAvoider, TurnsAwayFromAnObstacleOnOneSide)
{
	for (const double side : {1.0, -1.0})
	{
		const PointCloud cloud = wallCloud({1.2, side * -0.1}, {1.2, side * 2.0});
		const Avoidance result = run(onFloor(cloud));
		ASSERT_TRUE(result.heading_rad);
		EXPECT_LT(*result.heading_rad * side, 0.0);
		EXPECT_TRUE(result.deviates);
	}
}

TEST_P(MrptAvoider, WithATargetBeforeTheWallGoesThere)
{
	const PointCloud cloud = wallCloud({4.0, -3.0}, {4.0, 3.0});
	AvoiderInput input = onFloor(cloud);
	input.goal_distance_m = 1.5;
	const Avoidance result = run(input);
	ASSERT_TRUE(result.heading_rad);
	EXPECT_NEAR(*result.heading_rad, 0.0, 0.1);
	EXPECT_NEAR(result.open_path_m, 4.0 - 0.27, 0.05);
}

TEST_P(MrptAvoider, AnswersAreFiniteWithinTheSectorAndNeverIntoAnObstacle)
{
	std::mt19937 random(11);
	std::uniform_real_distribution<double> angle(-3.14, 3.14);
	int answers = 0;
	for (int trial = 0; trial < 300; ++trial)
	{
		const PointCloud cloud = randomCloud(random, trial, 3.0);
		AvoiderInput input = onFloor(cloud, angle(random));
		input.goal_distance_m = trial % 2 == 0 ? 0.0 : 0.01 * trial;
		const Avoidance result = run(input);
		EXPECT_TRUE(std::isfinite(result.open_path_m));
		if (!result.heading_rad) continue;
		++answers;
		ASSERT_TRUE(std::isfinite(*result.heading_rad));
		EXPECT_LE(std::abs(wrapToPi(*result.heading_rad - input.desired_rad)), 0.81);
		EXPECT_GT(result.open_path_m, 0.0);
		// Truth: no point of robot height lies in the disc swept over the open path, ahead of the robot.
		const Eigen::Vector2d along(std::cos(*result.heading_rad), std::sin(*result.heading_rad));
		for (std::size_t i = 0; i < cloud.size(); ++i)
		{
			const double height = std::abs(cloud.z[i]);
			if (cloud.z[i] >= 0.65 || height <= 0.05) continue;
			const Eigen::Vector2d point = cloud[i].cast<double>().head<2>();
			if (point.dot(along) <= 0.0) continue;
			const double travel = std::min(point.dot(along), result.open_path_m);
			EXPECT_GE((point - travel * along).norm(), 0.27 - 1e-6) << "trial " << trial;
		}
	}
	EXPECT_GT(answers, 30);
}

TEST_P(MrptAvoider, SameFrameSameHeadingHoweverOftenAsked)
{
	const PointCloud cloud = wallCloud({2.0, -0.6}, {2.0, 0.4});
	const PointCloud other = wallCloud({2.0, -0.2}, {2.0, 3.0});
	const Avoidance first = run(onFloor(cloud));
	run(onFloor(other));
	EXPECT_EQ(run(onFloor(cloud)).heading_rad, first.heading_rad);
}

std::string nameOfMethod(const testing::TestParamInfo<AvoiderMethod>& method)
{
	if (method.param == AvoiderMethod::holonomic_nd) return "ND";
	return method.param == AvoiderMethod::holonomic_vff ? "VFF" : "FullEval";
}

INSTANTIATE_TEST_SUITE_P(All, MrptAvoider,
                         testing::Values(AvoiderMethod::holonomic_nd, AvoiderMethod::holonomic_vff,
                                         AvoiderMethod::holonomic_full_eval),
                         nameOfMethod);
}  // namespace
}  // namespace explore
