// Which direction the robot wants (θ_d): the paper's nearest door, else vanishing point, else straight on.
#pragma once

#include <explore/core/results.h>
#include <explore/core/robot.h>

namespace explore
{
struct GoalChoice
{
	Goal goal;                                  ///< door, corridor (the vanishing point) or none
	std::optional<double> door_rad;             ///< θ_o: to the nearest door the robot fits through
	std::optional<double> vanishing_point_rad;  ///< θ_v: of the vanishing point with the most inliers
	double desired_rad = 0;                     ///< θ_d
};

/** Whether a report says that the robot can go through now: its verdict is open, ajar or passage, it is wide enough
 *  (diameter + 0.10 m) and, where its height is known, high enough. */
[[nodiscard]] bool fitsThrough(const Door& door, const RobotConfig& robot);

/** The paper's policy: θ_d = θ_o where a door was found, else θ_v, else 0 (straight on). The
 *  door is the nearest that fitsThrough(), by the horizontal distance of its centre. Azimuths are about the floor's
 *  normal. */
GoalChoice chooseGoal(const Percepts& percepts, const RobotConfig& robot);
}  // namespace explore
