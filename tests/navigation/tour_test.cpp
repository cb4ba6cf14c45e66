#include <explore/navigation/tour.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>

#include "support/random_points.h"

namespace explore
{
namespace
{
constexpr double kNever = std::numeric_limits<double>::infinity();

TourCosts randomCosts(std::mt19937& random, std::size_t count, double share_of_infinite)
{
	const auto cost = [&]
	{ return test::uniform(random, 0, 1) < share_of_infinite ? kNever : test::uniform(random, 0, 10); };
	TourCosts costs;
	for (std::size_t i = 0; i < count; ++i)
	{
		costs.from_robot.push_back(cost());
		costs.to_home.push_back(cost());
		std::vector<double>& row = costs.between.emplace_back();
		for (std::size_t j = 0; j < count; ++j) row.push_back(i == j ? 0.0 : cost());
	}
	return costs;
}

double costOf(const TourCosts& costs, const std::vector<std::size_t>& order)
{
	double sum = costs.from_robot[order.front()] + costs.to_home[order.back()];
	for (std::size_t i = 1; i < order.size(); ++i) sum += costs.between[order[i - 1]][order[i]];
	return sum;
}

/** Of all orders that begin with `first`. */
double cheapestFrom(const TourCosts& costs, std::size_t first)
{
	std::vector<std::size_t> order(costs.from_robot.size());
	std::iota(order.begin(), order.end(), 0U);
	double cheapest = kNever;
	do
		if (order.front() == first) cheapest = std::min(cheapest, costOf(costs, order));
	while (std::next_permutation(order.begin(), order.end()));
	return cheapest;
}

TEST(ToursByFirst, AreTheCheapestOfAllOrders)
{
	std::mt19937 random(11);
	for (int trial = 0; trial < 400; ++trial)
	{
		SCOPED_TRACE(trial);
		const std::size_t count = 1 + random() % 7;
		const TourCosts costs = randomCosts(random, count, trial % 4 == 0 ? 0.5 : trial % 4 == 1 ? 0.1 : 0.0);
		const std::vector<double> tours = toursByFirst(costs);
		ASSERT_EQ(tours.size(), count);
		for (std::size_t first = 0; first < count; ++first)
		{
			const double cheapest = cheapestFrom(costs, first);
			if (cheapest == kNever)
				EXPECT_EQ(tours[first], kNever) << "no order leads through all";
			else
				EXPECT_NEAR(tours[first], cheapest, 1e-9);
		}
		if (testing::Test::HasFailure()) return;
	}
}

TEST(ToursByFirst, OfNoPlacesThereAreNone)
{
	EXPECT_TRUE(toursByFirst(TourCosts()).empty());
}

/** Places, the robot and home on the floor; a turn at each place costs up to 0.5 m more one way than the other. */
TourCosts randomFloor(std::mt19937& random, std::size_t count)
{
	const auto place = [&] { return Eigen::Vector2d(test::uniform(random, 0, 30), test::uniform(random, 0, 30)); };
	const Eigen::Vector2d robot = place(), home = place();
	std::vector<Eigen::Vector2d> places;
	for (std::size_t i = 0; i < count; ++i) places.push_back(place());
	TourCosts costs;
	for (const Eigen::Vector2d& from : places)
	{
		costs.from_robot.push_back((from - robot).norm());
		costs.to_home.push_back((from - home).norm());
		std::vector<double>& row = costs.between.emplace_back();
		for (const Eigen::Vector2d& to : places) row.push_back((from - to).norm() + test::uniform(random, 0, 0.5));
	}
	return costs;
}

/** The cheapest way from `at` through all that are not in `gone`, and home; by trying all that may come next. */
double cheapestOn(const TourCosts& costs, std::size_t at, std::size_t gone, std::map<std::size_t, double>& known)
{
	const std::size_t count = costs.to_home.size();
	if (gone == (std::size_t{1} << count) - 1) return costs.to_home[at];
	const auto [entry, is_new] = known.try_emplace(gone * count + at, kNever);
	if (!is_new) return entry->second;
	double cheapest = kNever;
	for (std::size_t next = 0; next < count; ++next)
		if ((gone >> next & 1U) == 0)
			cheapest = std::min(
			    cheapest, costs.between[at][next] + cheapestOn(costs, next, gone | std::size_t{1} << next, known));
	return known[gone * count + at] = cheapest;
}

TEST(ToursByFirst, ThroughManyPlacesAreHardlyLongerThanTheCheapestAndNeverShorter)
{
	std::mt19937 random(13);
	double worst = 1.0, sum = 0.0;
	constexpr int kTrials = 12;
	for (int trial = 0; trial < kTrials; ++trial)
	{
		SCOPED_TRACE(trial);
		const TourCosts costs = randomFloor(random, kExactTourPlaces + 1 + random() % 3);
		const std::vector<double> tours = toursByFirst(costs);
		ASSERT_EQ(tours.size(), costs.to_home.size());
		std::map<std::size_t, double> known;
		double cheapest = kNever;
		for (std::size_t first = 0; first < tours.size(); ++first)
		{
			const double least = costs.from_robot[first] + cheapestOn(costs, first, std::size_t{1} << first, known);
			EXPECT_GE(tours[first], least - 1e-6);
			EXPECT_LE(tours[first], 1.1 * least);
			cheapest = std::min(cheapest, least);
		}
		const double ratio = *std::min_element(tours.begin(), tours.end()) / cheapest;
		worst = std::max(worst, ratio);
		sum += ratio;
	}
	EXPECT_LE(worst, 1.03);
	EXPECT_LE(sum / kTrials, 1.005);
}

TEST(ToursByFirst, AlongALineOfManyPlacesGoOutAndComeBack)
{
	TourCosts costs;
	constexpr int kPlaces = 45;
	constexpr double kRobot_m = 20.5;
	for (int i = 0; i < kPlaces; ++i)
	{
		costs.from_robot.push_back(std::abs(i + 1 - kRobot_m));
		costs.to_home.push_back(i + 1);
		std::vector<double>& row = costs.between.emplace_back();
		for (int j = 0; j < kPlaces; ++j) row.push_back(std::abs(i - j));
	}
	const std::vector<double> tours = toursByFirst(costs);
	const double best = (kPlaces - kRobot_m) + kPlaces;
	EXPECT_NEAR(tours[20], best, 1e-9) << "the next one outward";
	EXPECT_NEAR(tours[kPlaces - 1], best, 1e-9) << "the others on the way back";
	EXPECT_NEAR(tours[0], kRobot_m - 1 + (kPlaces - 1) + kPlaces, 1e-9) << "home first, then out";
}

TEST(ToursByFirst, APlaceThatNoWayLeadsToMakesManyInfinite)
{
	std::mt19937 random(14);
	TourCosts costs = randomFloor(random, 20);
	for (std::vector<double>& row : costs.between) row[7] = kNever;
	const std::vector<double> tours = toursByFirst(costs);
	for (std::size_t first = 0; first < tours.size(); ++first)
		EXPECT_EQ(tours[first] == kNever, first != 7) << "it can only come first";
}

TEST(ToursByFirst, EndAtHome)
{
	// Places at 1, 2 and 9 m on a line, home at 0, the robot at 3: out to the far one first, then back past the others.
	const std::vector<double> at{1, 2, 9};
	TourCosts costs;
	for (const double place : at)
	{
		costs.from_robot.push_back(std::abs(place - 3));
		costs.to_home.push_back(place);
		std::vector<double>& row = costs.between.emplace_back();
		for (const double other : at) row.push_back(std::abs(place - other));
	}
	EXPECT_EQ(toursByFirst(costs), (std::vector<double>{2 + 1 + 7 + 9, 1 + 7 + 8 + 1, 6 + 7 + 1 + 1}));
}
}  // namespace
}  // namespace explore
