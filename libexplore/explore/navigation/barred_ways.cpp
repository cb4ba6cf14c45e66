#include <explore/core/geometry.h>
#include <explore/navigation/barred_ways.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
/** Between the places that are kept of a way; a body that bars it is wider. */
constexpr double kBetween_m = 0.3;
/** What bars a way is looked at from here: nearer the camera measures nothing. */
constexpr double kWatch_m = 1.0;
/** A frontier is waited for that has so much unknown space within that distance. */
constexpr double kRoom_m = 1.0, kWorthWaiting_m2 = 0.5;
/** Where people come and go the robot would wait now before the one and now before the other. */
constexpr int kMostWaits = 4;

double distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
	return (a - b).norm();
}

OpenWay wayOf(const LookTarget& target, const MissionPlan& plan)
{
	OpenWay way;
	way.frontier_in_map = target.frontier_in_map;
	const auto add = [&](CellIndex cell)
	{
		if (cell == kNoCell || plan.map.passable[cell] == 0) return;
		const Eigen::Vector3d place = plan.map.middleOf(cell);
		if (way.places_in_map.empty() || distance(way.places_in_map.back(), place) >= kBetween_m)
			way.places_in_map.push_back(place);
	};
	for (const CellIndex cell : plan.field.wayTo(target.look.cell)) add(cell);
	const Eigen::Vector3d ahead = target.frontier_in_map - target.stand_in_map;
	const int steps = static_cast<int>(std::ceil(ahead.norm() / kBetween_m));
	for (int i = 1; i <= steps; ++i) add(plan.map.cellOf(target.stand_in_map + ahead * i / steps));
	return way;
}

/** Whether a frontier's cell that `counts` is there. */
template <class Counts>
bool isFrontierAt(const Eigen::Vector3d& middle, const PlanMap& map, const Frontiers& frontiers, const Counts& counts)
{
	const auto is_there = [&](CellIndex cell)
	{ return counts(cell) && distance(map.middleOf(cell), middle) < kSameGoal_m; };
	const auto& clusters = frontiers.clusters();
	return std::any_of(clusters.begin(), clusters.end(),
	                   [&](const FrontierCluster& cluster)
	                   { return std::any_of(cluster.cells.begin(), cluster.cells.end(), is_there); });
}

bool isRoomy(const PlanMap& map, CellIndex cell)
{
	return map.cells[cell] == CellState::unknown && map.obstacle_m[cell] >= map.fit_m;
}

/** How much unknown space there is around a place in which the body has room. */
double roomAround(const PlanMap& map, const Eigen::Vector3d& place)
{
	const CellIndex cell = map.cellOf(place);
	if (cell == kNoCell) return 0.0;
	const int reach = static_cast<int>(kRoom_m / map.frame.resolution_m);
	int count = 0;
	for (int dy = -reach; dy <= reach; ++dy)
		for (int dx = -reach; dx <= reach; ++dx)
		{
			const Eigen::Array3i at = map.placeOf(cell) + Eigen::Array3i(dx, dy, 0);
			count += dx * dx + dy * dy <= reach * reach && map.contains(at) && isRoomy(map, map.cellAt(at)) ? 1 : 0;
		}
	return count * map.frame.resolution_m * map.frame.resolution_m;
}

/** Whether nothing is to be found out there any more, or too little to wait for. */
bool isSettled(const OpenWay& way, const PlanMap& map, const FrontierMemory& memory)
{
	if (roomAround(map, way.frontier_in_map) < kWorthWaiting_m2) return true;
	const CellIndex cell = map.cellOf(way.frontier_in_map);
	return map.cells[cell] == CellState::free &&
	       !isFrontierAt(way.frontier_in_map, map, memory.frontiers, [](CellIndex) { return true; });
}

/** Whether the robot would still get into what is unknown there, barred or not. */
bool isWanted(const OpenWay& way, const PlanMap& map, const FrontierMemory& memory)
{
	return isFrontierAt(way.frontier_in_map, map, memory.frontiers,
	                    [&](CellIndex cell) { return map.near_wanted[cell] != 0; });
}

std::optional<LookTarget> lookAtWhatBars(const OpenWay& way, const MissionPlan& plan, const PlanConfig& config)
{
	const auto& places = way.places_in_map;
	const auto is_reached = [&](const Eigen::Vector3d& place) { return plan.field.reaches(plan.map.cellOf(place)); };
	// What lies beyond may be reached past it, with too little room to explore it.
	const auto barred = std::find_if_not(places.rbegin(), places.rend(), is_reached);
	const auto last = std::find_if(barred, places.rend(), is_reached);
	if (last == places.rend()) return std::nullopt;
	LookTarget target;
	target.frontier_in_map = *(last - 1);
	target.stand_in_map = placeToWatchFrom({last, places.rend()}, target.frontier_in_map);
	const CellIndex cell = plan.map.cellOf(target.stand_in_map);
	if (!plan.field.reaches(cell)) return std::nullopt;
	target.look = {cell, azimuthOf(target.frontier_in_map - target.stand_in_map)};
	target.travel_m = plan.field.costTo(cell);
	target.gain_m2 = config.min_gain_m2;
	target.purpose = LookPurpose::barred_way;
	return target;
}
}  // namespace

void rememberWays(std::vector<OpenWay>& ways, const MissionPlan& plan, const FrontierMemory& memory)
{
	std::erase_if(ways, [&](const OpenWay& way) { return isSettled(way, plan.map, memory); });
	for (const LookTarget& target : plan.targets)
	{
		if (target.purpose != LookPurpose::frontier) continue;
		std::erase_if(ways, [&](const OpenWay& way)
		              { return distance(way.frontier_in_map, target.frontier_in_map) < kSameGoal_m; });
		ways.push_back(wayOf(target, plan));
	}
}

std::vector<LookTarget> looksAtWhatBars(const Mission& mission, const MissionPlan& plan, const FrontierMemory& memory,
                                        const PlanConfig& config)
{
	std::vector<LookTarget> looks;
	const bool waiting = mission.goal && mission.goal->purpose == LookPurpose::barred_way;
	if (mission.open_ways.waits >= kMostWaits && !waiting) return looks;
	for (const OpenWay& way : mission.open_ways.ways)
	{
		if (isGivenUp(mission, way.frontier_in_map) || isWanted(way, plan.map, memory)) continue;
		const auto look = lookAtWhatBars(way, plan, config);
		if (!look || isGivenUp(mission, look->frontier_in_map)) continue;
		const auto same = [&](const LookTarget& other)
		{ return distance(other.frontier_in_map, look->frontier_in_map) < kSameGoal_m; };
		if (std::none_of(looks.begin(), looks.end(), same)) looks.push_back(*look);
	}
	return looks;
}

Eigen::Vector3d placeToWatchFrom(const std::vector<Eigen::Vector3d>& nearest_first, const Eigen::Vector3d& watched)
{
	const auto place = std::find_if(nearest_first.begin(), nearest_first.end(),
	                                [&](const Eigen::Vector3d& one) { return distance(one, watched) >= kWatch_m; });
	return place == nearest_first.end() ? nearest_first.back() : *place;
}
}  // namespace explore
