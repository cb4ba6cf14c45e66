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
	const Tour best = shortestTour(costs);
	if (best.order.empty()) return nearestTarget(input.targets);
	if (input.current && places.front() == *input.current &&
	    shortestTour(costs, 0).cost_m < best.cost_m + config.switch_gain_m)
		return *input.current;
	return places[best.order.front()];
}

std::size_t nearestTarget(const std::vector<LookTarget>& targets)
{
	const auto nearest =
	    std::min_element(targets.begin(), targets.end(),
	                     [](const LookTarget& a, const LookTarget& b) { return a.travel_m < b.travel_m; });
	return static_cast<std::size_t>(nearest - targets.begin());
}
}  // namespace explore
