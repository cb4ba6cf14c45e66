#include <explore/memory/stations.h>
#include <gtest/gtest.h>

#include <random>

#include "support/random_points.h"

namespace explore
{
namespace
{
TEST(Stations, StandingAndTurningIsOneStation)
{
	Stations stations;
	stations.moveTo({1, 2, 0.5});
	const std::uint16_t first = stations.current();
	EXPECT_NE(first, 0);
	for (int i = 0; i < 100; ++i) stations.moveTo({1.0 + 0.002 * i, 2, 0.5});
	EXPECT_EQ(stations.current(), first);
	EXPECT_TRUE(stations.isRecent(first));
	EXPECT_FALSE(stations.isRecent(0));
}

TEST(Stations, AreForgottenAtADistanceHoweverTheWayWasMade)
{
	std::mt19937 random(3);
	for (int trial = 0; trial < 200; ++trial)
	{
		Stations stations;
		Eigen::Vector3d at = Eigen::Vector3d::Zero();
		stations.moveTo(at);
		at += test::uniform(random, 0.0, 0.24) * test::randomDirection(random);
		stations.moveTo(at);
		const std::uint16_t then = stations.current();
		const Eigen::Vector3d from = at;
		for (int step = 0; step < 50; ++step)
		{
			at += test::uniform(random, 0.0, trial % 2 == 0 ? 0.1 : 1.5) * test::randomDirection(random);
			stations.moveTo(at);
			ASSERT_FALSE((at - from).norm() >= Stations::kForgotten_m && stations.isRecent(then)) << trial;
		}
	}
}

TEST(Stations, NumbersBeginAnewWhenTheyRunOut)
{
	Stations stations;
	int restarts = 0;
	for (int i = 0; i < 70'000; ++i) restarts += static_cast<int>(stations.moveTo({0.25 * i, 0, 0}));
	EXPECT_EQ(restarts, 1);
	EXPECT_LT(stations.current(), 10'000);
}
}  // namespace
}  // namespace explore
