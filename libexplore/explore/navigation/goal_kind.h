// What a place to look from is called: a door to go through, a corridor to follow, a look around, or just a frontier.
#pragma once

#include <explore/memory/frontier_memory.h>
#include <explore/navigation/look_targets.h>

#include <optional>
#include <vector>

namespace explore
{
struct GoalName
{
	GoalKind kind = GoalKind::frontier;
	std::optional<int> track;
};

/** door: the way there, or the look from there, passes a confirmed door that the robot fits through and has not been
 *  through; the first one. corridor: the frontier lies in a confirmed corridor. look: it is seen from where the robot
 * is. */
GoalName nameOf(const LookTarget& target, const std::vector<CellIndex>& way, const PlanMap& map,
                const FrontierMemory& memory, const RobotConfig& robot);
}  // namespace explore
