// What it costs to get from one place to every other over the plan.
#pragma once

#include <explore/navigation/plan_map.h>

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

namespace explore
{
inline constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();

/** Costs and where they come from, by cell. */
struct TravelField
{
	CellIndex start = kNoCell;
	double cost_per_m = 1;            ///< units of `cost` for a metre in the open
	std::vector<std::uint32_t> cost;  ///< kUnreached where no way leads
	std::vector<CellIndex> from;      ///< the cell before on the way; of the start the start itself

	[[nodiscard]] bool reaches(CellIndex cell) const { return cell != kNoCell && cost[cell] != kUnreached; }
	/** In metres of open way. */
	[[nodiscard]] double costTo(CellIndex cell) const { return static_cast<double>(cost[cell]) / cost_per_m; }
	/** The cells from the start to `cell`, both included; empty where no way leads. */
	[[nodiscard]] std::vector<CellIndex> wayTo(CellIndex cell) const;
};

/** Dijkstra over passable cells and their eight neighbours in the layer (a MAV: also the layers above and below), near
 *  obstacles at a higher cost, with a bucket for each cost (Dial 1969). A robot that stands where it would not be
 *  allowed to go may leave: free cells within its radius of the start count as passable, at a high cost; so do spots
 *  where it was stopped lately. */
TravelField travelFrom(const PlanMap& map, CellIndex start, const RobotConfig& robot, const PlanConfig& config);
/** The same, but only until the costs of `ends` are known; others may be left unreached, or too dear. */
TravelField travelBetween(const PlanMap& map, CellIndex start, const std::vector<CellIndex>& ends,
                          const RobotConfig& robot, const PlanConfig& config);

/** The corners [m, map frame] of the way from the field's start to `cell`, shortened where the straight way is free and
 *  keeps as far from obstacles as the way that it replaces, or by the comfortable distance. Empty where no way leads.
 */
std::vector<Eigen::Vector3d> shortenedWay(const PlanMap& map, const TravelField& field, CellIndex cell,
                                          const PlanConfig& config);

/** Length [m] of a polyline. */
double lengthOf(const std::vector<Eigen::Vector3d>& way);
}  // namespace explore
