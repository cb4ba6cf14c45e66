#include <explore/navigation/tour.h>
#include <explore/navigation/tour_search.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace explore
{
namespace
{
constexpr double kNever_m = std::numeric_limits<double>::infinity();

/** The cheapest ways home through subsets of the places: those of `bits`, beginning with one of them. */
struct WaysHome
{
	explicit WaysHome(std::size_t places) : count(places), cost(places << places, kNever_m) {}
	[[nodiscard]] double& from(std::size_t bits, std::size_t first) { return cost[bits * count + first]; }

	std::size_t count;
	std::vector<double> cost;
};

bool isIn(std::size_t bits, std::size_t place)
{
	return (bits >> place & 1U) != 0;
}

/** Puts each of the other places before those of `bits`. */
void extend(WaysHome& ways, const TourCosts& costs, std::size_t bits, std::size_t first)
{
	const double rest = ways.from(bits, first);
	for (std::size_t before = 0; before < ways.count; ++before)
	{
		if (isIn(bits, before)) continue;
		double& cost = ways.from(bits | (std::size_t{1} << before), before);
		cost = std::min(cost, costs.between[before][first] + rest);
	}
}

/** Costs of the cheapest tours, by dynamic programming. */
std::vector<double> cheapestByFirst(const TourCosts& costs)
{
	const std::size_t count = costs.from_robot.size();
	const std::size_t all = (std::size_t{1} << count) - 1;
	WaysHome ways(count);
	for (std::size_t i = 0; i < count; ++i) ways.from(std::size_t{1} << i, i) = costs.to_home[i];
	for (std::size_t bits = 1; bits < all; ++bits)
		for (std::size_t first = 0; first < count; ++first)
			if (isIn(bits, first)) extend(ways, costs, bits, first);
	std::vector<double> tours = costs.from_robot;
	for (std::size_t first = 0; first < count; ++first) tours[first] += ways.from(all, first);
	return tours;
}

/** Costs of short tours: each from its own nearest neighbours, and from the best of those. */
std::vector<double> shortByFirst(const TourCosts& costs)
{
	const TourSearch search(costs);
	std::vector<double> tours;
	TourOrder best;
	for (std::size_t first = 0; first < search.home(); ++first)
	{
		TourOrder order = search.nearestNeighbours(first);
		search.improve(order);
		tours.push_back(search.costOf(order));
		if (best.empty() || tours.back() < search.costOf(best)) best = std::move(order);
	}
	for (std::size_t first = 0; first < tours.size(); ++first)
	{
		TourOrder order = best;
		const auto at = std::find(order.begin(), order.end(), first);
		std::rotate(order.begin(), at, at + 1);
		search.improve(order);
		tours[first] = std::min(tours[first], search.costOf(order));
		if (tours[first] >= TourSearch::kNever_m) tours[first] = kNever_m;
	}
	return tours;
}
}  // namespace

std::vector<double> toursByFirst(const TourCosts& costs)
{
	if (costs.from_robot.empty()) return {};
	return costs.from_robot.size() <= kExactTourPlaces ? cheapestByFirst(costs) : shortByFirst(costs);
}
}  // namespace explore
