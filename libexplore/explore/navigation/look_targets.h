// Where to look next: for each frontier the place from which the robot sees most of what lies behind it.
#pragma once

#include <explore/memory/frontiers.h>
#include <explore/navigation/look_gain.h>
#include <explore/navigation/travel_field.h>

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

namespace explore
{
/** Frontiers nearer to each other than this are one goal. */
inline constexpr double kSameGoal_m = 0.6;

/** What a look is to show. */
enum class LookPurpose
{
	frontier,
	way_out,     ///< for a robot that is cut off
	barred_way,  ///< whether what bars the way to a frontier is still there
};

/** A place that is worth going to. */
struct LookTarget
{
	Look look;                                                  ///< where to stand and how to turn
	Eigen::Vector3d stand_in_map = Eigen::Vector3d::Zero();     ///< middle of the look's cell
	Eigen::Vector3d frontier_in_map = Eigen::Vector3d::Zero();  ///< middle of the frontier's cells that matter
	double gain_m2 = 0;
	double travel_m = 0;                                         ///< from the robot, as TravelField has it
	double pocket_m2 = std::numeric_limits<double>::infinity();  ///< of unknown space there: no more can come of it
	LookPurpose purpose = LookPurpose::frontier;
	bool left_lately = false;  ///< as a goal
};

/** A frontier as the planner needs it: its cells beside wanted space. */
struct WantedFrontier
{
	std::vector<CellIndex> cells;
	Eigen::Vector3d middle_in_map = Eigen::Vector3d::Zero();  ///< the cell nearest to the mean
};
/** Those of the clusters that have any, in their order. */
std::vector<WantedFrontier> wantedFrontiers(const PlanMap& map, const std::vector<FrontierCluster>& clusters);

/** The best look at a frontier from where the robot can get, of those that see it if any do: the one with the least
 * way, where what a place shows less than the best one counts as way, and so does being near to things. No value: no
 * place shows min_gain_m2. */
std::optional<LookTarget> bestLook(const PlanMap& map, const TravelField& field, const WantedFrontier& frontier,
                                   const PlanConfig& config);

/** The reachable place nearest to a frontier, looking at it: where an explorer without looks would go. */
std::optional<LookTarget> nearestPlace(const PlanMap& map, const TravelField& field, const WantedFrontier& frontier,
                                       const PlanConfig& config);

/** Looks all around from where the robot stands: for one that finds no way on. What it is to see is 1 m away. */
std::vector<LookTarget> looksAround(const PlanMap& map, const TravelField& field, const PlanConfig& config);

/** Without those whose frontier another look, of more gain, shows as well: what may come of them is added to its own.
 */
std::vector<LookTarget> withoutRedundant(const PlanMap& map, std::vector<LookTarget> targets, const PlanConfig& config);
}  // namespace explore
