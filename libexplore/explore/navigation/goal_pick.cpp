#include <explore/core/geometry.h>
#include <explore/navigation/goal_pick.h>
#include <explore/navigation/tour.h>

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
	if (order.size() > kMaxTourPlaces) order.resize(kMaxTourPlaces);
	return order;
}

TourCosts costsBetween(const PickInput& input, const std::vector<std::size_t>& places, const RobotConfig& robot,
                       const PlanConfig& config)
{
	TourCosts costs;
	std::vector<CellIndex> ends{input.home};
	for (const std::size_t i : places) ends.push_back(input.targets[i].look.cell);
	for (const std::size_t i : places)
	{
		const LookTarget& from = input.targets[i];
		costs.from_robot.push_back(from.travel_m + turnCost(input.yaw_rad, from.look.yaw_rad, config));
		const TravelField field = travelBetween(input.map, from.look.cell, ends, robot, config);
		std::vector<double> row;
		for (const std::size_t j : places)
		{
			const Look& to = input.targets[j].look;
			row.push_back(costTo(field, to.cell) + turnCost(from.look.yaw_rad, to.yaw_rad, config));
		}
		costs.between.push_back(std::move(row));
		costs.to_home.push_back(costTo(field, input.home));
	}
	return costs;
}
}  // namespace

std::size_t firstOfTour(const PickInput& input, const RobotConfig& robot, const PlanConfig& config)
{
	if (input.targets.size() == 1) return 0;
	const std::vector<std::size_t> places = nearestTargets(input);
	const TourCosts costs = costsBetween(input, places, robot, config);
	const std::vector<double> tours = toursByFirst(costs);
	const double best_m = *std::min_element(tours.begin(), tours.end());
	// Cut off from home no tour is better than another: to change between them would end none.
	if (best_m >= kNoWay_m) return input.current.value_or(nearestTarget(input.targets));
	if (input.current && places.front() == *input.current && tours.front() < best_m + config.switch_gain_m)
		return *input.current;
	std::size_t first = 0;
	for (std::size_t i = 0; i < places.size(); ++i)
	{
		const bool better = tours[first] >= best_m + kTie_m || costs.from_robot[i] < costs.from_robot[first];
		if (tours[i] < best_m + kTie_m && better) first = i;
	}
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
