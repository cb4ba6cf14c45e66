#include <explore/core/geometry.h>
#include <explore/navigation/look_targets.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace explore
{
namespace
{
/** Places to stand are tried this far apart, twice as far around a frontier that is not near the robot, and up to this
 *  far from a frontier. */
constexpr int kLattice_cells = 6;
constexpr double kNear_m = 6.0;
constexpr double kFarthest_m = 3.0;
/** Of what the best place shows a place must show this share; what it shows less counts as way, so much for all of it.
 */
constexpr double kGoodShare = 0.3, kLess_m = 1.0;
/** Metres of way for a metre that a place is too near to things. */
constexpr double kCrowding = 3.0;

LookTarget targetAt(const PlanMap& map, const TravelField& field, CellIndex cell, const WantedFrontier& frontier)
{
	LookTarget target;
	target.stand_in_map = map.middleOf(cell);
	target.frontier_in_map = frontier.middle_in_map;
	const Eigen::Vector2d toward = (target.frontier_in_map - target.stand_in_map).head<2>();
	target.look = {cell, std::atan2(toward.y(), toward.x())};
	target.travel_m = field.costTo(cell);
	return target;
}

/** Reachable places around a frontier's middle, on a lattice that stays where it is; all where `lattice` is 1. */
template <class Visit>
void forEachPlace(const PlanMap& map, const TravelField& field, const WantedFrontier& frontier, int lattice,
                  const Visit& visit)
{
	const Eigen::Array3i middle = map.placeOf(map.cellOf(frontier.middle_in_map));
	const int reach = static_cast<int>(kFarthest_m / map.frame.resolution_m);
	const auto first = [&](int from) { return (from - reach + lattice - 1) / lattice * lattice; };
	for (int y = first(middle.y()); y <= middle.y() + reach; y += lattice)
		for (int x = first(middle.x()); x <= middle.x() + reach; x += lattice)
		{
			const Eigen::Array3i place(x, y, middle.z());
			if (!map.contains(place) || (place - middle).matrix().squaredNorm() > reach * reach) continue;
			const CellIndex cell = map.cellAt(place);
			if (map.passable[cell] != 0 && field.reaches(cell)) visit(cell);
		}
}

/** Whether it can be seen from where the robot is, whether it might stand there or not. */
bool isNearStart(const PlanMap& map, const TravelField& field, const WantedFrontier& frontier, const PlanConfig& config)
{
	if (field.start == kNoCell) return false;
	return (map.middleOf(field.start) - frontier.middle_in_map).norm() <= config.view_range_m;
}

/** How much way a place counts for that is nearer to things than is comfortable: less is seen from there. */
double crowding(const PlanMap& map, CellIndex cell, const PlanConfig& config)
{
	return kCrowding * std::max(0.0, config.comfort_m - static_cast<double>(map.obstacle_m[cell]));
}

/** The place to look from that costs least. */
const LookTarget& cheapest(const PlanMap& map, const std::vector<LookTarget>& targets, double best_gain_m2,
                           const PlanConfig& config)
{
	const auto cost = [&](const LookTarget& target)
	{
		const double less_m = kLess_m * (1.0 - target.gain_m2 / best_gain_m2);
		return std::pair(target.travel_m + crowding(map, target.look.cell, config) + less_m, target.look.cell);
	};
	return *std::min_element(targets.begin(), targets.end(),
	                         [&](const LookTarget& a, const LookTarget& b) { return cost(a) < cost(b); });
}

/** Where a frontier might be looked at from: those places that see it. What a look shows through a wall that was not
 *  seen yet lies on this side of it; only a frontier that no place sees is looked for from all of them. */
std::vector<LookTarget> placesAround(const PlanMap& map, const TravelField& field, const WantedFrontier& frontier,
                                     int lattice_cells, const PlanConfig& config)
{
	std::vector<LookTarget> all, seeing;
	const auto consider = [&](CellIndex cell)
	{
		all.push_back(targetAt(map, field, cell, frontier));
		if (sees(map, all.back().look, frontier.middle_in_map, config)) seeing.push_back(all.back());
	};
	forEachPlace(map, field, frontier, lattice_cells, consider);
	if (isNearStart(map, field, frontier, config)) consider(field.start);
	return seeing.empty() ? all : seeing;
}

std::optional<LookTarget> bestOfLattice(const PlanMap& map, const TravelField& field, const WantedFrontier& frontier,
                                        int lattice_cells, const PlanConfig& config)
{
	std::vector<LookTarget> targets = placesAround(map, field, frontier, lattice_cells, config);
	double best_gain_m2 = 0.0;
	for (LookTarget& target : targets)
	{
		target.gain_m2 = lookGain(map, target.look, config);
		best_gain_m2 = std::max(best_gain_m2, target.gain_m2);
	}
	if (best_gain_m2 < config.min_gain_m2) return std::nullopt;
	std::erase_if(targets, [&](const LookTarget& target)
	              { return target.gain_m2 < std::max(kGoodShare * best_gain_m2, config.min_gain_m2); });
	return cheapest(map, targets, best_gain_m2, config);
}
}  // namespace

std::vector<WantedFrontier> wantedFrontiers(const PlanMap& map, const std::vector<FrontierCluster>& clusters)
{
	std::vector<WantedFrontier> frontiers;
	for (const FrontierCluster& cluster : clusters)
	{
		WantedFrontier frontier;
		Eigen::Vector3d sum = Eigen::Vector3d::Zero();
		for (const CellIndex cell : cluster.cells)
		{
			if (map.near_wanted[cell] == 0) continue;
			frontier.cells.push_back(cell);
			sum += map.middleOf(cell);
		}
		if (frontier.cells.empty()) continue;
		const Eigen::Vector3d mean = sum / static_cast<double>(frontier.cells.size());
		const auto away = [&](CellIndex cell) { return (map.middleOf(cell) - mean).squaredNorm(); };
		const auto nearest = std::min_element(frontier.cells.begin(), frontier.cells.end(),
		                                      [&](CellIndex a, CellIndex b) { return away(a) < away(b); });
		frontier.middle_in_map = map.middleOf(*nearest);
		frontiers.push_back(std::move(frontier));
	}
	return frontiers;
}

std::optional<LookTarget> bestLook(const PlanMap& map, const TravelField& field, const WantedFrontier& frontier,
                                   const PlanConfig& config)
{
	if (field.start == kNoCell) return std::nullopt;
	const double away_m = (map.middleOf(field.start) - frontier.middle_in_map).norm();
	if (away_m > kNear_m)
		if (auto rough = bestOfLattice(map, field, frontier, 2 * kLattice_cells, config)) return rough;
	return bestOfLattice(map, field, frontier, kLattice_cells, config);
}

std::optional<LookTarget> nearestPlace(const PlanMap& map, const TravelField& field, const WantedFrontier& frontier,
                                       const PlanConfig& config)
{
	std::optional<LookTarget> nearest;
	double nearest_m = kFarthest_m;
	forEachPlace(map, field, frontier, 1,
	             [&](CellIndex cell)
	             {
		             const double away_m = (map.middleOf(cell) - frontier.middle_in_map).norm();
		             if (away_m >= nearest_m) return;
		             nearest_m = away_m;
		             nearest = targetAt(map, field, cell, frontier);
	             });
	if (!nearest && isNearStart(map, field, frontier, config)) nearest = targetAt(map, field, field.start, frontier);
	if (nearest) nearest->gain_m2 = lookGain(map, nearest->look, config);
	return nearest && nearest->gain_m2 >= config.min_gain_m2 ? nearest : std::nullopt;
}

std::vector<LookTarget> looksAround(const PlanMap& map, const TravelField& field, const PlanConfig& config)
{
	std::vector<LookTarget> looks;
	if (field.start == kNoCell) return looks;
	const int count = static_cast<int>(std::ceil(2.0 * std::numbers::pi / config.view_angle_rad));
	for (int i = 0; i < count; ++i)
	{
		LookTarget target;
		const double yaw_rad = wrapToPi(2.0 * std::numbers::pi * i / count);
		target.look = {field.start, yaw_rad};
		target.stand_in_map = map.middleOf(field.start);
		target.frontier_in_map = target.stand_in_map + Eigen::Vector3d(std::cos(yaw_rad), std::sin(yaw_rad), 0.0);
		target.gain_m2 = config.min_gain_m2;
		target.purpose = LookPurpose::way_out;
		looks.push_back(target);
	}
	return looks;
}

std::vector<LookTarget> withoutRedundant(const PlanMap& map, std::vector<LookTarget> targets, const PlanConfig& config)
{
	std::stable_sort(targets.begin(), targets.end(),
	                 [](const LookTarget& a, const LookTarget& b) { return a.gain_m2 > b.gain_m2; });
	std::vector<LookTarget> kept;
	for (const LookTarget& target : targets)
	{
		const auto shown = std::find_if(kept.begin(), kept.end(),
		                                [&](const LookTarget& other)
		                                { return sees(map, other.look, target.frontier_in_map, config); });
		if (shown == kept.end())
			kept.push_back(target);
		else
			shown->pocket_m2 += target.pocket_m2;
	}
	return kept;
}
}  // namespace explore
