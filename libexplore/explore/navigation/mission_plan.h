// One look at the map for the mission: where the robot can get to, what is worth looking at, and the way home.
#pragma once

#include <explore/navigation/mission.h>

#include <vector>

namespace explore
{
/** The robot does not turn back to a goal that it left less than so long ago unless it has done with the one since. */
inline constexpr double kLeft_s = 20.0;
[[nodiscard]] bool wasLeftLately(const Mission& mission, const LookTarget& target, double now_s);

/** Whether a frontier, or what bars the way to one, was looked at as often as it is. */
[[nodiscard]] bool isGivenUp(const Mission& mission, const Eigen::Vector3d& frontier_in_map);

/** All that a decision is made from. */
struct MissionPlan
{
	PlanMap map;
	AllowedArea area;
	CellIndex start = kNoCell, home = kNoCell;
	TravelField field;
	bool cut_off = false;                           ///< no way leads home, or anywhere, or the robot does not get on
	std::vector<Eigen::Vector3d> frontiers_in_map;  ///< middles of those that are worth a look
	std::vector<LookTarget> targets;                ///< looks that show them all
};

MissionPlan planNow(const Mission& mission, const FrontierMemory& memory, const MissionNow& now,
                    const RobotConfig& robot, const MissionConfig& config);

/** Cost of the way home [m]; 0 where none is known. */
double pathHome(const MissionPlan& plan);

/** Where a robot that goes home is to be, and how turned, in the map. */
struct HomePlace
{
	Eigen::Vector3d stand_in_map = Eigen::Vector3d::Zero();
	double yaw_rad = 0;
};
/** Home; while no way leads there a place on the way that the robot came by, from which it faces what has come into
 * that way since: people move on, and the map has to be shown that they did. */
HomePlace homePlace(const Mission& mission, const MissionPlan& plan);

/** The goal as one of the targets, with its place and yaw kept. */
LookTarget asTarget(const MissionGoal& goal, const MissionPlan& plan);
}  // namespace explore
