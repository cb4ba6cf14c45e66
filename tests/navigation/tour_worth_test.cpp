#include <explore/navigation/tour_worth.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "support/random_points.h"

namespace explore
{
namespace
{
constexpr double kMust = std::numeric_limits<double>::infinity();

/** Robot, places and home in the plane. */
TourCosts between(const Eigen::Vector2d& robot, const std::vector<Eigen::Vector2d>& places, const Eigen::Vector2d& home)
{
	TourCosts costs;
	costs.home_from_robot = (home - robot).norm();
	for (const Eigen::Vector2d& place : places)
	{
		costs.from_robot.push_back((place - robot).norm());
		costs.to_home.push_back((home - place).norm());
		std::vector<double>& row = costs.between.emplace_back();
		for (const Eigen::Vector2d& other : places) row.push_back((other - place).norm());
	}
	return costs;
}

/** Of the shortest of all orders of these places. */
double shortest(const TourCosts& costs, std::vector<std::size_t> places)
{
	if (places.empty()) return costs.home_from_robot;
	double least = kMust;
	do
	{
		double sum = costs.from_robot[places.front()] + costs.to_home[places.back()];
		for (std::size_t i = 1; i < places.size(); ++i) sum += costs.between[places[i - 1]][places[i]];
		least = std::min(least, sum);
	} while (std::next_permutation(places.begin(), places.end()));
	return least;
}

/** Way, and the worth of what is left out. */
double price(const TourCosts& costs, const std::vector<double>& worth_m, const std::vector<std::size_t>& kept)
{
	double sum = shortest(costs, kept);
	for (std::size_t i = 0; i < worth_m.size(); ++i)
		if (!std::ranges::binary_search(kept, i)) sum += worth_m[i];
	return sum;
}

std::vector<std::size_t> subset(std::size_t bits, std::size_t count)
{
	std::vector<std::size_t> places;
	for (std::size_t i = 0; i < count; ++i)
		if ((bits >> i & 1U) != 0) places.push_back(i);
	return places;
}

const Eigen::Vector2d kRobot(0, 0), kHome(10, 0);

TEST(PlacesWorthTheWay, OnTheWayAreThoseThatCostLessThanTheyAreWorth)
{
	// 2 m aside of a way of 10 m: 0.77 m of detour.
	const TourCosts costs = between(kRobot, {{5, 2}}, kHome);
	EXPECT_EQ(placesWorthTheWay(costs, {0.8}).size(), 1U);
	EXPECT_TRUE(placesWorthTheWay(costs, {0.7}).empty());
	EXPECT_EQ(placesWorthTheWay(costs, {kMust}).size(), 1U);
}

TEST(PlacesWorthTheWay, WhatIsNotWorthItAloneMayBeTogether)
{
	// The way to both is no longer than to one, and more than either is worth.
	const TourCosts costs = between(kRobot, {{5, 5}, {5, 5.1}}, kHome);
	EXPECT_TRUE(placesWorthTheWay(costs, {2.5, 1.0}).empty());
	EXPECT_EQ(placesWorthTheWay(costs, {2.5, 2.5}), (std::vector<std::size_t>{0, 1}));
	EXPECT_EQ(placesWorthTheWay(costs, {kMust, 0.3}), (std::vector<std::size_t>{0, 1})) << "one has to be gone to";
	EXPECT_EQ(placesWorthTheWay(costs, {kMust, 0.1}), (std::vector<std::size_t>{0}));
}

TEST(PlacesWorthTheWay, OfNoneThereAreNone)
{
	EXPECT_TRUE(placesWorthTheWay(between(kRobot, {}, kHome), {}).empty());
}

TEST(PlacesWorthTheWay, AreHardlyDearerThanTheBestOfAllChoices)
{
	std::mt19937 random(3);
	int best = 0, trials = 0;
	for (; trials < 300; ++trials)
	{
		SCOPED_TRACE(trials);
		const std::size_t count = 1 + random() % 6;
		std::vector<Eigen::Vector2d> places;
		std::vector<double> worth_m;
		for (std::size_t i = 0; i < count; ++i)
		{
			places.emplace_back(test::uniform(random, -2, 12), test::uniform(random, -6, 6));
			worth_m.push_back(random() % 3 == 0 ? kMust : test::uniform(random, 0, 8));
		}
		const TourCosts costs = between(kRobot, places, kHome);
		const std::vector<std::size_t> kept = placesWorthTheWay(costs, worth_m);
		ASSERT_TRUE(std::ranges::is_sorted(kept));
		for (std::size_t i = 0; i < count; ++i)
			ASSERT_TRUE(worth_m[i] != kMust || std::ranges::binary_search(kept, i)) << i << " is not to be left out";
		double least = kMust;
		for (std::size_t bits = 0; bits < (std::size_t{1} << count); ++bits)
			least = std::min(least, price(costs, worth_m, subset(bits, count)));
		const double paid = price(costs, worth_m, kept);
		EXPECT_LE(paid, 1.25 * least);
		best += paid < least + 1e-9 ? 1 : 0;
	}
	EXPECT_GE(best, trials * 9 / 10) << "nine of ten are the best there is";
}

TEST(CostsOfSome, AreThoseOfTheirPlaces)
{
	const std::vector<Eigen::Vector2d> places{{1, 2}, {3, 4}, {5, -6}};
	const TourCosts part = costsOfSome(between(kRobot, places, kHome), {0, 2});
	const TourCosts expected = between(kRobot, {places[0], places[2]}, kHome);
	EXPECT_EQ(part.from_robot, expected.from_robot);
	EXPECT_EQ(part.between, expected.between);
	EXPECT_EQ(part.to_home, expected.to_home);
	EXPECT_EQ(part.home_from_robot, expected.home_from_robot);
}
}  // namespace
}  // namespace explore
