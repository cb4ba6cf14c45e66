#include <explore/navigation/tour.h>

#include <limits>
#include <stdexcept>

namespace explore
{
namespace
{
constexpr double kNever = std::numeric_limits<double>::infinity();

/** The best ways through subsets of the places: those of `bits`, ending at one of them. */
struct Subsets
{
	explicit Subsets(std::size_t places)
	    : count(places), cost(places << places, kNever), before(places << places, places)
	{
	}
	[[nodiscard]] std::size_t at(std::size_t bits, std::size_t last) const { return bits * count + last; }

	std::size_t count;
	std::vector<double> cost;
	std::vector<std::size_t> before;
};

void extend(Subsets& ways, const TourCosts& costs, std::size_t bits, std::size_t last)
{
	const double so_far = ways.cost[ways.at(bits, last)];
	if (so_far == kNever) return;
	for (std::size_t next = 0; next < ways.count; ++next)
	{
		if ((bits >> next & 1U) != 0) continue;
		const std::size_t to = ways.at(bits | (std::size_t{1} << next), next);
		const double cost = so_far + costs.between[last][next];
		if (cost >= ways.cost[to]) continue;
		ways.cost[to] = cost;
		ways.before[to] = last;
	}
}

Tour cheapest(const Subsets& ways, const TourCosts& costs)
{
	Tour tour;
	tour.cost_m = kNever;
	const std::size_t all = (std::size_t{1} << ways.count) - 1;
	std::size_t last = ways.count;
	for (std::size_t end = 0; end < ways.count; ++end)
	{
		const double cost = ways.cost[ways.at(all, end)] + costs.to_home[end];
		if (cost >= tour.cost_m) continue;
		tour.cost_m = cost;
		last = end;
	}
	for (std::size_t bits = all; last < ways.count;)
	{
		tour.order.insert(tour.order.begin(), last);
		const std::size_t before = ways.before[ways.at(bits, last)];
		bits &= ~(std::size_t{1} << last);
		last = before;
	}
	return tour;
}

Tour solve(const TourCosts& costs, const std::vector<double>& from_robot)
{
	const std::size_t count = from_robot.size();
	if (count > kMaxTourPlaces) throw std::invalid_argument("a tour of too many places");
	if (count == 0) return {};
	Subsets ways(count);
	for (std::size_t i = 0; i < count; ++i) ways.cost[ways.at(std::size_t{1} << i, i)] = from_robot[i];
	for (std::size_t bits = 1; bits < std::size_t{1} << count; ++bits)
		for (std::size_t last = 0; last < count; ++last)
			if ((bits >> last & 1U) != 0) extend(ways, costs, bits, last);
	return cheapest(ways, costs);
}
}  // namespace

Tour shortestTour(const TourCosts& costs)
{
	return solve(costs, costs.from_robot);
}

Tour shortestTour(const TourCosts& costs, std::size_t first)
{
	std::vector<double> only(costs.from_robot.size(), kNever);
	only[first] = costs.from_robot[first];
	return solve(costs, only);
}
}  // namespace explore
