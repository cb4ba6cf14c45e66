#include <explore/navigation/tour_search.h>
#include <explore/navigation/tour_worth.h>

#include <algorithm>
#include <optional>

namespace explore
{
namespace
{
/** From a place, or from the robot, to a place, or home. */
double leg(const TourCosts& costs, std::optional<std::size_t> from, std::optional<std::size_t> to)
{
	if (!from) return to ? costs.from_robot[*to] : costs.home_from_robot;
	return to ? costs.between[*from][*to] : costs.to_home[*from];
}

/** Places of a tour in a row. */
struct Stretch
{
	std::size_t first = 0, count = 0;
	double saved_m = 0;  ///< by leaving it out, its worth taken off
};

/** The stretch whose leaving out saves most; `count` is 0 if none saves anything. */
Stretch leastWorth(const TourCosts& costs, const TourOrder& places, const std::vector<double>& worth_m)
{
	constexpr double kLeast_m = 1e-6;  // less is rounding
	const auto at = [&](std::size_t i) { return i < places.size() ? std::optional(places[i]) : std::nullopt; };
	Stretch least{0, 0, kLeast_m};
	for (std::size_t first = 0; first < places.size(); ++first)
	{
		const std::optional<std::size_t> before = first == 0 ? std::nullopt : at(first - 1);
		double way_m = leg(costs, before, at(first)), lost_m = 0.0;
		for (std::size_t last = first; last < places.size(); ++last)
		{
			way_m += leg(costs, at(last), at(last + 1));
			lost_m += worth_m[places[last]];
			const double saved_m = way_m - leg(costs, before, at(last + 1)) - lost_m;
			if (saved_m > least.saved_m) least = {first, last + 1 - first, saved_m};
		}
	}
	return least;
}

/** A short tour through all; without home at its end. */
TourOrder shortTour(const TourCosts& costs)
{
	const TourSearch search(costs);
	TourOrder best;
	for (std::size_t first = 0; first < search.home(); ++first)
	{
		TourOrder order = search.nearestNeighbours(first);
		search.improve(order);
		if (best.empty() || search.costOf(order) < search.costOf(best)) best = std::move(order);
	}
	if (!best.empty()) best.pop_back();
	return best;
}
}  // namespace

std::vector<std::size_t> placesWorthTheWay(const TourCosts& costs, const std::vector<double>& worth_m)
{
	TourOrder places = shortTour(costs);
	for (Stretch out = leastWorth(costs, places, worth_m); out.count != 0; out = leastWorth(costs, places, worth_m))
	{
		const auto first = places.begin() + static_cast<std::ptrdiff_t>(out.first);
		places.erase(first, first + static_cast<std::ptrdiff_t>(out.count));
	}
	std::sort(places.begin(), places.end());
	return places;
}

TourCosts costsOfSome(const TourCosts& costs, const std::vector<std::size_t>& places)
{
	const auto some = [&](const std::vector<double>& of_all)
	{
		std::vector<double> of_some(places.size());
		std::transform(places.begin(), places.end(), of_some.begin(), [&](std::size_t place) { return of_all[place]; });
		return of_some;
	};
	TourCosts part{some(costs.from_robot), {}, some(costs.to_home), costs.home_from_robot};
	for (const std::size_t place : places) part.between.push_back(some(costs.between[place]));
	return part;
}
}  // namespace explore
