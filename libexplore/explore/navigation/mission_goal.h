// What the robot sets out for, made from what the plan offers.
#pragma once

#include <explore/navigation/mission.h>

#include <vector>

namespace explore
{
struct MissionPlan;

MissionGoal goalFor(const LookTarget& target, const MissionPlan& plan, const FrontierMemory& memory, double now_s,
                    const RobotConfig& robot);

/** The way home, as it is now; how long it may take counts from when the robot first set out. */
MissionGoal goalHome(const Mission& mission, const MissionPlan& plan, double now_s, const RobotConfig& robot);

/** Takes the targets at the goal's frontier out: the goal stands for them, and for what may come of them. */
void standForTargets(MissionGoal& goal, std::vector<LookTarget>& targets);
}  // namespace explore
