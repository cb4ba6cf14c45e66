#include <explore/navigation/tour.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

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

TEST(ToursByFirst, TakeAsManyPlacesAsTheySayAndNoMore)
{
	std::mt19937 random(12);
	EXPECT_TRUE(toursByFirst(TourCosts()).empty());
	EXPECT_EQ(toursByFirst(randomCosts(random, kMaxTourPlaces, 0)).size(), kMaxTourPlaces);
	EXPECT_THROW(toursByFirst(randomCosts(random, kMaxTourPlaces + 1, 0)), std::invalid_argument);
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
