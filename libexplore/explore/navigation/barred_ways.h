// Ways that something has come into since they were planned: who stands in a door walks on, and what moved leaves a
// ghost in the map until the camera sees the place again.
#pragma once

#include <explore/memory/frontier_memory.h>
#include <explore/navigation/mission_plan.h>

#include <vector>

namespace explore
{
/** Keeps the ways of the plan's targets, and those kept before whose frontier is not settled: one stands there still,
 *  or what was free there is not any more. */
void rememberWays(std::vector<OpenWay>& ways, const MissionPlan& plan, const FrontierMemory& memory);

/** A look from each of the ways that is barred now at what bars it, where the plan does not go for its frontier any
 *  more. Those that were waited for in vain are left out, and all when the robot waited too often in a row. */
std::vector<LookTarget> looksAtWhatBars(const Mission& mission, const MissionPlan& plan, const FrontierMemory& memory,
                                        const PlanConfig& config);

/** Of places on a way, the nearest to `watched` first, the first one from which the camera measures it. Not empty. */
Eigen::Vector3d placeToWatchFrom(const std::vector<Eigen::Vector3d>& nearest_first, const Eigen::Vector3d& watched);
}  // namespace explore
