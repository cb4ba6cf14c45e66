#include <explore/core/geometry.h>
#include <explore/navigation/coarse_map.h>
#include <explore/navigation/goal_pick.h>
#include <explore/navigation/tour.h>
#include <explore/navigation/tour_worth.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace explore
{
namespace
{
constexpr double kNoWay_m = 1e6;
/** Of tours that are as long but for this the one is taken whose first place is nearest: on the way to a far one it
 *  would be passed by. */
constexpr double kTie_m = 0.5;
/** A tour goes through no more places: those that are left out are far. */
constexpr std::size_t kMostPlaces = 48;

double costTo(const TravelField& field, CellIndex cell)
{
	return field.reaches(cell) ? field.costTo(cell) : kNoWay_m;
}

double turnCost(double from_rad, double to_rad, const PlanConfig& config)
{
	return config.turn_cost_m * std::abs(wrapToPi(to_rad - from_rad));
}

/** Those that a tour is planned over: the nearest, and the current one in any case. */
std::vector<std::size_t> nearestTargets(const PickInput& input)
{
	std::vector<std::size_t> order(input.targets.size());
	std::iota(order.begin(), order.end(), 0U);
	const auto key = [&](std::size_t i) { return input.current == i ? -1.0 : input.targets[i].travel_m; };
	std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
	if (order.size() > kMostPlaces) order.resize(kMostPlaces);
	return order;
}

/** On the coarse map: a tour needs the costs from each place to each other. */
TourCosts costsBetween(const PickInput& input, const std::vector<std::size_t>& places, const RobotConfig& robot,
                       const PlanConfig& config)
{
	const int factor = coarseness(input.map, robot, config);
	const PlanMap coarse = coarsened(input.map, factor);
	const auto square = [&](CellIndex cell) { return squareOf(input.map, coarse, cell, factor); };
	const auto look = [&](std::size_t i) -> const Look& { return input.targets[i].look; };
	std::vector<CellIndex> ends{square(input.home)};
	for (const std::size_t i : places) ends.push_back(square(look(i).cell));
	const auto costs_from = [&](double yaw_rad, const TravelField& field)
	{
		std::vector<double> row(places.size());
		std::transform(places.begin(), places.end(), row.begin(),
		               [&](std::size_t j)
		               { return costTo(field, square(look(j).cell)) + turnCost(yaw_rad, look(j).yaw_rad, config); });
		return row;
	};
	TourCosts costs;
	const TravelField from_robot = travelBetween(coarse, square(input.field.start), ends, robot, config);
	costs.from_robot = costs_from(input.yaw_rad, from_robot);
	costs.home_from_robot = costTo(from_robot, ends.front());
	for (const std::size_t i : places)
	{
		const TravelField field = travelBetween(coarse, square(look(i).cell), ends, robot, config);
		costs.between.push_back(costs_from(look(i).yaw_rad, field));
		costs.to_home.push_back(costTo(field, ends.front()));
	}
	return costs;
}

/** False if nothing is left then. The current goal is left only for a way that is shorter by switch_gain_m. */
bool leaveOutWhatIsNotWorthIt(const PickInput& input, TourCosts& costs, std::vector<std::size_t>& places,
                              const PlanConfig& config)
{
	if (costs.home_from_robot >= kNoWay_m) return true;
	std::vector<double> worth_m;
	for (const std::size_t i : places)
	{
		const double pocket_m2 = input.targets[i].pocket_m2;
		const double stay_m = input.current == i ? config.switch_gain_m : 0.0;
		worth_m.push_back(std::isinf(pocket_m2) ? pocket_m2 : config.pocket_worth * pocket_m2 + stay_m);
	}
	const std::vector<std::size_t> kept = placesWorthTheWay(costs, worth_m);
	costs = costsOfSome(costs, kept);
	std::vector<std::size_t> kept_places(kept.size());
	std::transform(kept.begin(), kept.end(), kept_places.begin(), [&](std::size_t i) { return places[i]; });
	places = std::move(kept_places);
	return !places.empty();
}

/** The index with the least cost among those that `may`; of those that cost as much but for kTie_m the one that is
 *  nearest to the robot. `tours` if there is none. */
template <class May>
std::size_t leastTour(const std::vector<double>& tours, const TourCosts& costs, const May& may)
{
	double least_m = std::numeric_limits<double>::infinity();
	for (std::size_t i = 0; i < tours.size(); ++i)
		if (may(i)) least_m = std::min(least_m, tours[i]);
	std::size_t first = tours.size();
	for (std::size_t i = 0; i < tours.size(); ++i)
	{
		if (!may(i) || tours[i] > least_m + kTie_m) continue;
		if (first == tours.size() || costs.from_robot[i] < costs.from_robot[first]) first = i;
	}
	return first;
}
}  // namespace

std::optional<std::size_t> firstOfTour(const PickInput& input, const RobotConfig& robot, const PlanConfig& config)
{
	std::vector<std::size_t> places = nearestTargets(input);
	TourCosts costs = costsBetween(input, places, robot, config);
	if (!leaveOutWhatIsNotWorthIt(input, costs, places, config)) return std::nullopt;
	const std::vector<double> tours = toursByFirst(costs);
	const std::size_t any = leastTour(tours, costs, [](std::size_t) { return true; });
	// Cut off from home no tour is better than another: to change between them would end none.
	if (tours[any] >= kNoWay_m) return input.current.value_or(nearestTarget(input.targets));
	const auto is_fresh = [&](std::size_t i) { return !input.targets[places[i]].left_lately; };
	const std::size_t fresh = leastTour(tours, costs, is_fresh);
	const std::size_t first = fresh != tours.size() && tours[fresh] < tours[any] + config.return_gain_m ? fresh : any;
	if (input.current && places.front() == *input.current && tours.front() < tours[first] + config.switch_gain_m)
		return *input.current;
	return places[first];
}

std::size_t nearestTarget(const std::vector<LookTarget>& targets)
{
	const auto nearest =
	    std::min_element(targets.begin(), targets.end(),
	                     [](const LookTarget& a, const LookTarget& b) { return a.travel_m < b.travel_m; });
	return static_cast<std::size_t>(nearest - targets.begin());
}
}  // namespace explore
