#include <explore/navigation/tour.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace explore
{
namespace
{
/** The cheapest ways home through subsets of the places: those of `bits`, beginning with one of them. */
struct WaysHome
{
	explicit WaysHome(std::size_t places)
	    : count(places), cost(places << places, std::numeric_limits<double>::infinity())
	{
	}
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
}  // namespace

std::vector<double> toursByFirst(const TourCosts& costs)
{
	const std::size_t count = costs.from_robot.size();
	if (count > kMaxTourPlaces) throw std::invalid_argument("a tour of too many places");
	if (count == 0) return {};
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
}  // namespace explore
