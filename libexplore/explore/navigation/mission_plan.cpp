#include <explore/core/geometry.h>
#include <explore/navigation/barred_ways.h>
#include <explore/navigation/mission_plan.h>
#include <explore/navigation/pockets.h>

#include <algorithm>
#include <utility>

namespace explore
{
namespace
{
/** A frontier that was looked at so often, and shows hardly more than it did, is left alone. */
constexpr int kMaxTries = 2;
constexpr double kSameGain = 1.3;
/** A robot that gets no farther than this is boxed in. */
constexpr double kStep_m = 0.7;

/** Whether it was tried at least so often, when it held more than so much. */
bool wasTried(const Mission& mission, const Eigen::Vector3d& frontier_in_map, int tries, double gain_m2)
{
	return std::any_of(mission.tried.begin(), mission.tried.end(),
	                   [&](const TriedFrontier& tried)
	                   {
		                   const bool same = (tried.frontier_in_map - frontier_in_map).norm() < kSameGoal_m;
		                   return same && tried.tries >= tries && tried.gain_m2 > gain_m2;
	                   });
}

bool wasTriedInVain(const Mission& mission, const LookTarget& target)
{
	return wasTried(mission, target.frontier_in_map, kMaxTries, target.gain_m2 / kSameGain);
}

bool wasLookedAt(const Mission& mission, const WantedFrontier& frontier)
{
	return wasTried(mission, frontier.middle_in_map, 1, 0.0);
}

/** Finds the plan's frontiers and looks. */
void findTargets(MissionPlan& plan, const FrontierMemory& memory, const Mission& mission, const MissionConfig& config)
{
	std::vector<LookTarget> targets;
	const bool looks = config.policy == GoalPolicy::explore;
	const Pockets pockets = pocketsOf(plan.map);
	for (const WantedFrontier& frontier : wantedFrontiers(plan.map, memory.frontiers.clusters()))
	{
		// What stayed after a look is looked at from as near as the robot gets.
		auto target = looks && !wasLookedAt(mission, frontier)
		                  ? bestLook(plan.map, plan.field, frontier, config.plan)
		                  : nearestPlace(plan.map, plan.field, frontier, config.plan);
		if (!target || wasTriedInVain(mission, *target)) continue;
		target->pocket_m2 = pockets.besideThose(plan.map, frontier.cells);
		targets.push_back(*target);
		plan.frontiers_in_map.push_back(frontier.middle_in_map);
	}
	plan.targets = looks ? withoutRedundant(plan.map, std::move(targets), config.plan) : std::move(targets);
}

/** Whether the robot can get farther than a step from where it stands. */
bool findsAWay(const MissionPlan& plan)
{
	const auto is_away = [&](CellIndex cell)
	{ return (plan.map.middleOf(cell) - plan.map.middleOf(plan.start)).head<2>().norm() > kStep_m; };
	for (CellIndex cell = 0; cell < plan.map.cells.size(); ++cell)
		if (plan.field.reaches(cell) && is_away(cell)) return true;
	return false;
}

bool isCutOff(const MissionPlan& plan)
{
	return !plan.field.reaches(plan.home) || !findsAWay(plan);
}
}  // namespace

bool wasLeftLately(const Mission& mission, const LookTarget& target, double now_s)
{
	return std::any_of(mission.left.begin(), mission.left.end(),
	                   [&](const LeftGoal& left)
	                   {
		                   const bool same = (left.stand_in_map - target.stand_in_map).norm() < kSameGoal_m;
		                   return same && now_s - left.at_s < kLeft_s;
	                   });
}

bool isGivenUp(const Mission& mission, const Eigen::Vector3d& frontier_in_map)
{
	return wasTried(mission, frontier_in_map, kMaxTries, 0.0);
}

MissionPlan planNow(const Mission& mission, const FrontierMemory& memory, const MissionNow& now,
                    const RobotConfig& robot, const MissionConfig& config)
{
	MissionPlan plan;
	plan.area = allowedArea(config.bounds);
	PlanInput input{memory.layers, plan.area, now.map_from_robot.translation(), mission.trail_in_map, {}};
	for (const BlockedSpot& spot : mission.blocked) input.blocked_in_map.push_back(spot.at_in_map);
	plan.map = planMap(input, robot, config.plan);
	plan.start = plan.map.cellOf(input.robot_in_map);
	plan.home = plan.map.cellOf(mission.map_from_home->translation());
	plan.field = travelFrom(plan.map, plan.start, robot, config.plan);
	plan.cut_off = mission.held || isCutOff(plan);
	findTargets(plan, memory, mission, config);
	if (mission.held || (plan.cut_off && plan.targets.empty()))
	{
		std::vector<LookTarget> around = looksAround(plan.map, plan.field, config.plan);
		std::erase_if(around, [&](const LookTarget& target) { return wasTriedInVain(mission, target); });
		if (!around.empty()) plan.targets = std::move(around);
	}
	return plan;
}

double pathHome(const MissionPlan& plan)
{
	return plan.field.reaches(plan.home) ? plan.field.costTo(plan.home) : 0.0;
}

HomePlace homePlace(const Mission& mission, const MissionPlan& plan)
{
	const Eigen::Isometry3d& home = *mission.map_from_home;
	if (plan.field.reaches(plan.home)) return {home.translation(), azimuthOf(home.linear().col(0))};
	const std::vector<Eigen::Vector3d>& trail = mission.trail_in_map;
	// The trail begins at home, so there is such a place, and ends where the robot is.
	const auto blocked =
	    std::find_if_not(trail.rbegin(), trail.rend(),
	                     [&](const Eigen::Vector3d& place) { return plan.field.reaches(plan.map.cellOf(place)); });
	const Eigen::Vector3d watched = blocked == trail.rend() ? trail.front() : *blocked;
	const std::vector<Eigen::Vector3d> open(blocked.base(), trail.end());
	HomePlace place;
	place.stand_in_map = open.empty() ? trail.back() : placeToWatchFrom(open, watched);
	place.yaw_rad = azimuthOf(watched - place.stand_in_map);
	return place;
}

LookTarget asTarget(const MissionGoal& goal, const MissionPlan& plan)
{
	const CellIndex cell = plan.map.cellOf(goal.stand_in_map);
	return {{cell, goal.yaw_rad},    goal.stand_in_map, goal.frontier_in_map, goal.gain_m2,
	        plan.field.costTo(cell), goal.pocket_m2,    goal.purpose,         false};
}
}  // namespace explore
