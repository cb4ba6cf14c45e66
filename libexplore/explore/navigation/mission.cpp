#include <explore/core/geometry.h>
#include <explore/navigation/barred_ways.h>
#include <explore/navigation/goal_pick.h>
#include <explore/navigation/mission.h>
#include <explore/navigation/mission_goal.h>
#include <explore/navigation/mission_plan.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace explore
{
namespace
{
double yawIn(const Eigen::Isometry3d& map_from_robot)
{
	return azimuthOf(map_from_robot.linear().col(0));
}

Eigen::Vector3d placeIn(const Eigen::Isometry3d& map_from_robot)
{
	return map_from_robot.translation();
}

/** What is asked of a goal that is reached: the camera points there. */
constexpr double kArrive_rad = 0.14;
/** Without a frame for longer the robot is told to stand, and no goal is blamed for the time that this lasts. */
constexpr double kSilence_s = 1.0;
/** How long the robot waits for a barred way to become free. */
constexpr double kWait_s = 10.0;
/** Between the places of the trail. */
constexpr double kTrail_m = 0.1;

void addTry(Mission& mission, const MissionGoal& goal, double gain_m2)
{
	for (TriedFrontier& tried : mission.tried)
	{
		if ((tried.frontier_in_map - goal.frontier_in_map).norm() >= kSameGoal_m) continue;
		++tried.tries;
		tried.gain_m2 = std::max(tried.gain_m2, gain_m2);
		return;
	}
	mission.tried.push_back({goal.frontier_in_map, gain_m2, 1});
}

bool isReached(const MissionGoal& goal, const MissionNow& now, const PlanConfig& config)
{
	if (!goal.reachable) return false;
	const double away_m = (goal.stand_in_map - placeIn(now.map_from_robot)).head<2>().norm();
	const bool home = goal.kind == GoalKind::home;
	const double turn_rad = std::abs(wrapToPi(goal.yaw_rad - yawIn(now.map_from_robot)));
	return away_m <= (home ? config.home_m : config.arrive_m) && (home || turn_rad <= kArrive_rad);
}

/** Reached, and waited for what it is to show. */
bool isDone(MissionGoal& goal, const MissionNow& now, const PlanConfig& config)
{
	if (!isReached(goal, now, config)) return false;
	if (goal.purpose != LookPurpose::barred_way) return true;
	if (!goal.waits_since_s) goal.waits_since_s = now.t_s;
	return now.t_s - *goal.waits_since_s >= kWait_s;
}

/** Whether the goal still shows something, and a way leads there. */
bool isWorthKeeping(const MissionGoal& goal, const MissionPlan& plan, const PlanConfig& config)
{
	if (goal.purpose == LookPurpose::way_out) return plan.cut_off;
	const CellIndex cell = plan.map.cellOf(goal.stand_in_map);
	const bool stands_there = cell == plan.field.start;
	if (!plan.field.reaches(cell) || (plan.map.passable[cell] == 0 && !stands_there)) return false;
	if (goal.purpose == LookPurpose::barred_way) return !plan.field.reaches(plan.map.cellOf(goal.frontier_in_map));
	return lookGain(plan.map, {cell, goal.yaw_rad}, config) >= config.min_gain_m2;
}

bool waitsForAWay(const LookTarget& target)
{
	return target.purpose == LookPurpose::barred_way;
}

/** Counts how often the robot waited in a row. */
void countWait(OpenWays& ways, const MissionGoal& goal, bool done)
{
	if (goal.purpose == LookPurpose::barred_way)
		++ways.waits;
	else if (done && goal.purpose == LookPurpose::frontier && goal.kind != GoalKind::home)
		ways.waits = 0;
}

/** Takes leave of the goal, which is `done` when it was reached or has nothing to show any more. */
void leave(Mission& mission, double now_s, bool done)
{
	mission.left.push_back({mission.goal->stand_in_map, now_s});
	std::erase_if(mission.left, [&](const LeftGoal& left) { return now_s - left.at_s > kLeft_s; });
	mission.undone = !done;
	countWait(mission.open_ways, *mission.goal, done);
	mission.goal.reset();
}

/** Sets out for one of the targets, the current goal being one of them while it is worth keeping. False: none is worth
 *  the way. */
bool chooseTarget(Mission& mission, MissionPlan& plan, const FrontierMemory& memory, const MissionNow& now,
                  const RobotConfig& robot, const MissionConfig& config)
{
	const bool waits = std::any_of(plan.targets.begin(), plan.targets.end(), waitsForAWay);
	const bool looking = mission.goal && mission.goal->kind != GoalKind::home &&
	                     waits == (mission.goal->purpose == LookPurpose::barred_way);
	if (plan.targets.empty() && !looking) return false;
	if (mission.goal || mission.undone)
		for (LookTarget& target : plan.targets) target.left_lately = wasLeftLately(mission, target, now.t_s);
	PickInput input{plan.map, plan.field, plan.targets, yawIn(now.map_from_robot), plan.home, std::nullopt};
	if (looking)
	{
		standForTargets(*mission.goal, plan.targets);
		plan.targets.push_back(asTarget(*mission.goal, plan));
		input.current = plan.targets.size() - 1;
	}
	const bool tours = config.policy == GoalPolicy::explore;
	std::optional<std::size_t> pick = input.current;
	if (tours)
		pick = firstOfTour(input, robot, config.plan);
	else if (!pick)
		pick = nearestTarget(plan.targets);
	if (pick && pick == input.current) return true;
	if (mission.goal && (pick || looking)) leave(mission, now.t_s, false);
	if (!pick) return false;
	mission.phase = MissionPhase::explore;
	mission.end = MissionEnd::none;
	mission.goal = goalFor(plan.targets[*pick], plan, memory, now.t_s, robot);
	mission.goal->chosen_at_m = mission.path_m;
	return true;
}

/** Waits for barred ways only when nothing else is left. */
bool chooseGoal(Mission& mission, MissionPlan& plan, const FrontierMemory& memory, const MissionNow& now,
                const RobotConfig& robot, const MissionConfig& config)
{
	if (chooseTarget(mission, plan, memory, now, robot, config)) return true;
	plan.targets = looksAtWhatBars(mission, plan, memory, config.plan);
	return chooseTarget(mission, plan, memory, now, robot, config);
}

/** Why the robot has to go home now although there is more to see. */
MissionEnd budgetSpent(const Mission& mission, const MissionPlan& plan, const MissionNow& now, const RobotConfig& robot,
                       const MissionConfig& config)
{
	if (mission.end == MissionEnd::time_budget || mission.end == MissionEnd::path_budget) return mission.end;
	const double needed_m = pathHome(plan) * (1.0 + config.budget.reserve);
	const double needed_s = 2.0 * needed_m / robot.max_speed_mps;
	if (config.budget.time_s > 0.0 && now.t_s - mission.started_at_s + needed_s >= config.budget.time_s)
		return MissionEnd::time_budget;
	if (config.budget.path_m > 0.0 && mission.path_m + needed_m >= config.budget.path_m) return MissionEnd::path_budget;
	return MissionEnd::none;
}

void goHome(Mission& mission, MissionEnd why, const MissionPlan& plan, const MissionNow& now, const RobotConfig& robot)
{
	mission.phase = MissionPhase::go_home;
	mission.end = why;
	mission.goal = goalHome(mission, plan, now.t_s, robot);
}

/** Why what is still worth a look was left. */
std::optional<LeftOverReason> whyWanted(MissionEnd end)
{
	if (end == MissionEnd::nothing_left) return LeftOverReason::sealed;
	return end == MissionEnd::cut_off ? std::optional(LeftOverReason::out_of_reach) : std::nullopt;
}

void replan(Mission& mission, const FrontierMemory& memory, const MissionNow& now, const RobotConfig& robot,
            const MissionConfig& config)
{
	mission.planned_at_s = now.t_s;
	std::erase_if(mission.blocked, [&](const BlockedSpot& spot) { return spot.until_s < now.t_s; });
	MissionPlan plan = planNow(mission, memory, now, robot, config);
	mission.open_frontiers = plan.targets.size();
	rememberWays(mission.open_ways.ways, plan, memory);
	if (mission.goal && mission.goal->kind != GoalKind::home && !isWorthKeeping(*mission.goal, plan, config.plan))
	{
		// What comes and goes while the robot stands there would be looked at for ever.
		if (mission.path_m - mission.goal->chosen_at_m < kTrail_m)
			addTry(mission, *mission.goal, mission.goal->gain_m2);
		leave(mission, now.t_s, true);
		mission.goal_lost = true;
	}

	const MissionEnd spent = budgetSpent(mission, plan, now, robot, config);
	if (spent != MissionEnd::none)
		goHome(mission, spent, plan, now, robot);
	else if (!chooseGoal(mission, plan, memory, now, robot, config))
		goHome(mission, plan.cut_off ? MissionEnd::cut_off : MissionEnd::nothing_left, plan, now, robot);
	if (mission.phase == MissionPhase::go_home)
		mission.left_over =
		    leftOver({plan.map, memory, plan.field, plan.area, whyWanted(mission.end), plan.frontiers_in_map});
	mission.way_in_map = shortenedWay(plan.map, plan.field, plan.map.cellOf(mission.goal->stand_in_map), config.plan);
	if (!mission.way_in_map.empty()) mission.way_in_map.back() = mission.goal->stand_in_map;
}

void count(Mission& mission, const MissionNow& now)
{
	const Eigen::Vector3d at = placeIn(now.map_from_robot);
	if (!mission.map_from_home)
	{
		mission.map_from_home = now.map_from_robot;
		mission.started_at_s = now.t_s;
	}
	if (mission.robot_in_map) mission.path_m += (at - *mission.robot_in_map).norm();
	if (mission.goal) mission.goal->chosen_at_s += std::max(0.0, now.t_s - mission.last_at_s - kSilence_s);
	mission.robot_in_map = at;
	mission.last_at_s = now.t_s;
	if (mission.trail_in_map.empty() || (at - mission.trail_in_map.back()).norm() >= kTrail_m)
	{
		mission.trail_in_map.push_back(at);
		mission.held = false;
	}
}
}  // namespace

std::string_view nameOf(MissionEnd end)
{
	static constexpr std::array<std::string_view, 5> kNames{"", "nothing reachable left", "time budget", "path budget",
	                                                        "no way on"};
	return kNames.at(static_cast<std::size_t>(end));
}

void pursue(Mission& mission, const FrontierMemory& memory, const MissionNow& now, const RobotConfig& robot,
            const MissionConfig& config)
{
	count(mission, now);
	mission.goal_lost = false;
	if (mission.phase == MissionPhase::done) return;
	bool plans = now.t_s - mission.planned_at_s >= config.plan.period_s || !mission.goal;
	const bool reached = mission.goal && isDone(*mission.goal, now, config.plan);
	if (reached || (mission.goal && now.t_s - mission.goal->chosen_at_s > mission.goal->patience_s))
	{
		if (mission.goal->kind == GoalKind::home)
		{
			mission.phase = MissionPhase::done;
			mission.home_reached = reached;
			return;
		}
		addTry(mission, *mission.goal, mission.goal->gain_m2);
		mission.held = !reached && mission.path_m - mission.goal->chosen_at_m < kTrail_m;
		leave(mission, now.t_s, reached);
		plans = true;
	}
	if (plans) replan(mission, memory, now, robot, config);
}
}  // namespace explore
