#include <explore/navigation/tour.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
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

/** Of all orders, of those that begin with `first`. */
double cheapestOfAll(const TourCosts& costs, std::optional<std::size_t> first)
{
	std::vector<std::size_t> order(costs.from_robot.size());
	std::iota(order.begin(), order.end(), 0U);
	double cheapest = kNever;
	do
		if (!first || order.front() == *first) cheapest = std::min(cheapest, costOf(costs, order));
	while (std::next_permutation(order.begin(), order.end()));
	return cheapest;
}

void expectCheapest(const Tour& tour, const TourCosts& costs, std::optional<std::size_t> first)
{
	const double cheapest = cheapestOfAll(costs, first);
	if (cheapest == kNever)
	{
		EXPECT_EQ(tour.cost_m, kNever);
		EXPECT_TRUE(tour.order.empty()) << "no order leads through all";
		return;
	}
	EXPECT_NEAR(tour.cost_m, cheapest, 1e-9);
	std::vector<std::size_t> places = tour.order;
	std::ranges::sort(places);
	std::vector<std::size_t> each(costs.from_robot.size());
	std::iota(each.begin(), each.end(), 0U);
	ASSERT_EQ(places, each) << "each place once";
	EXPECT_NEAR(costOf(costs, tour.order), tour.cost_m, 1e-9);
	EXPECT_EQ(tour.order.front(), first.value_or(tour.order.front()));
}

TEST(ShortestTour, IsTheCheapestOfAllOrders)
{
	std::mt19937 random(11);
	for (int trial = 0; trial < 400; ++trial)
	{
		SCOPED_TRACE(trial);
		const std::size_t count = 1 + random() % 7;
		const TourCosts costs = randomCosts(random, count, trial % 4 == 0 ? 0.5 : trial % 4 == 1 ? 0.1 : 0.0);
		expectCheapest(shortestTour(costs), costs, std::nullopt);
		const std::size_t first = random() % count;
		expectCheapest(shortestTour(costs, first), costs, first);
		if (testing::Test::HasFailure()) return;
	}
}

TEST(ShortestTour, ThroughNothingCostsNothing)
{
	const Tour tour = shortestTour(TourCosts());
	EXPECT_TRUE(tour.order.empty());
	EXPECT_EQ(tour.cost_m, 0.0);
}

TEST(ShortestTour, TakesAsManyPlacesAsItSaysAndNoMore)
{
	std::mt19937 random(12);
	EXPECT_EQ(shortestTour(randomCosts(random, kMaxTourPlaces, 0)).order.size(), kMaxTourPlaces);
	EXPECT_THROW(shortestTour(randomCosts(random, kMaxTourPlaces + 1, 0)), std::invalid_argument);
}

TEST(ShortestTour, EndsNearHome)
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
	EXPECT_EQ(shortestTour(costs).order, (std::vector<std::size_t>{2, 1, 0}));
	EXPECT_DOUBLE_EQ(shortestTour(costs).cost_m, 6 + 9);
	EXPECT_EQ(shortestTour(costs, 1).order, (std::vector<std::size_t>{1, 2, 0}));
}
}  // namespace
}  // namespace explore
