#include <explore/core/geometry.h>
#include <explore/navigation/goal_kind.h>
#include <explore/navigation/goal_pick.h>
#include <explore/navigation/mission.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace explore
{
namespace
{
/** What is asked of a goal that is reached: the camera points there. */
constexpr double kArrive_rad = 0.14;
/** The robot does not turn back to a goal that it left less than so long ago. */
constexpr double kLeft_s = 20.0, kSameGoal_m = 0.6;
/** A frontier that was looked at so often, and shows hardly more than it did, is left alone. */
constexpr int kMaxTries = 2;
constexpr double kSameGain = 1.3;
/** How long a goal may take: so many times as long as the way at full speed, and a while to turn and wait. */
constexpr double kPatience = 4.0, kPatience_s = 30.0;

double yawOf(const Eigen::Isometry3d& map_from_robot)
{
	return azimuthOf(map_from_robot.linear().col(0));
}

Eigen::Vector3d placeOf(const Eigen::Isometry3d& map_from_robot)
{
	return map_from_robot.translation();
}

/** One look at the map: all that a decision is made from. */
struct Plan
{
	PlanMap map;
	AllowedArea area;
	CellIndex start = kNoCell, home = kNoCell;
	TravelField field;
	std::vector<LookTarget> targets;
};

bool wasTried(const Mission& mission, const LookTarget& target)
{
	return std::any_of(mission.tried.begin(), mission.tried.end(),
	                   [&](const TriedFrontier& tried)
	                   {
		                   const bool same = (tried.frontier_in_map - target.frontier_in_map).norm() < kSameGoal_m;
		                   return same && tried.tries >= kMaxTries && target.gain_m2 < kSameGain * tried.gain_m2;
	                   });
}

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

std::vector<LookTarget> targetsOf(const Plan& plan, const FrontierMemory& memory, const Mission& mission,
                                  const MissionConfig& config)
{
	std::vector<LookTarget> targets;
	const bool looks = config.policy == GoalPolicy::explore;
	for (const WantedFrontier& frontier : wantedFrontiers(plan.map, memory.frontiers.clusters()))
	{
		const auto target = looks ? bestLook(plan.map, plan.field, frontier, config.plan)
		                          : nearestPlace(plan.map, plan.field, frontier, config.plan);
		if (target && !wasTried(mission, *target)) targets.push_back(*target);
	}
	return looks ? withoutRedundant(plan.map, std::move(targets), config.plan) : targets;
}

Plan planNow(const Mission& mission, const FrontierMemory& memory, const MissionNow& now, const RobotConfig& robot,
             const MissionConfig& config)
{
	Plan plan;
	plan.area = allowedArea(config.bounds);
	PlanInput input{memory.layers, plan.area, placeOf(now.map_from_robot), {}};
	for (const BlockedSpot& spot : mission.blocked) input.blocked_in_map.push_back(spot.at_in_map);
	plan.map = planMap(input, robot, config.plan);
	plan.start = plan.map.cellOf(input.robot_in_map);
	plan.home = plan.map.cellOf(placeOf(*mission.map_from_home));
	plan.field = travelFrom(plan.map, plan.start, robot, config.plan);
	plan.targets = targetsOf(plan, memory, mission, config);
	return plan;
}

bool isReached(const MissionGoal& goal, const MissionNow& now, const PlanConfig& config)
{
	const double away_m = (goal.stand_in_map - placeOf(now.map_from_robot)).head<2>().norm();
	const bool home = goal.kind == GoalKind::home;
	const double turn_rad = std::abs(wrapToPi(goal.yaw_rad - yawOf(now.map_from_robot)));
	return away_m <= (home ? config.home_m : config.arrive_m) && (home || turn_rad <= kArrive_rad);
}

/** Whether the goal still shows something, and a way leads there. */
bool isWorthKeeping(const MissionGoal& goal, const Plan& plan, const PlanConfig& config)
{
	const CellIndex cell = plan.map.cellOf(goal.stand_in_map);
	const bool stands_there = cell == plan.field.start;
	if (!plan.field.reaches(cell) || (plan.map.passable[cell] == 0 && !stands_there)) return false;
	return lookGain(plan.map, {cell, goal.yaw_rad}, config) >= config.min_gain_m2;
}

/** The goal as one of the targets, with its place and yaw kept. */
LookTarget asTarget(const MissionGoal& goal, const Plan& plan)
{
	const CellIndex cell = plan.map.cellOf(goal.stand_in_map);
	return {{cell, goal.yaw_rad}, goal.stand_in_map, goal.frontier_in_map, goal.gain_m2, plan.field.costTo(cell)};
}

void leave(Mission& mission, double now_s)
{
	if (mission.goal) mission.left.push_back({mission.goal->stand_in_map, now_s});
	std::erase_if(mission.left, [&](const LeftGoal& left) { return now_s - left.at_s > kLeft_s; });
	mission.goal.reset();
}

bool wasLeftLately(const Mission& mission, const LookTarget& target, double now_s)
{
	return std::any_of(mission.left.begin(), mission.left.end(),
	                   [&](const LeftGoal& left)
	                   {
		                   const bool same = (left.stand_in_map - target.stand_in_map).norm() < kSameGoal_m;
		                   return same && now_s - left.at_s < kLeft_s;
	                   });
}

MissionGoal goalFor(const LookTarget& target, const Plan& plan, const FrontierMemory& memory, const MissionNow& now,
                    const RobotConfig& robot)
{
	MissionGoal goal;
	goal.stand_in_map = target.stand_in_map;
	goal.frontier_in_map = target.frontier_in_map;
	goal.yaw_rad = target.look.yaw_rad;
	goal.gain_m2 = target.gain_m2;
	goal.chosen_at_s = now.t_s;
	goal.patience_s = kPatience_s + kPatience * target.travel_m / robot.max_speed_mps;
	const GoalName name = nameOf(target, plan.field.wayTo(target.look.cell), plan.map, memory, robot);
	goal.kind = name.kind;
	goal.track = name.track;
	return goal;
}

/** Cost of the way home [m]; 0 where none is known. */
double pathHome(const Plan& plan)
{
	return plan.field.reaches(plan.home) ? plan.field.costTo(plan.home) : 0.0;
}

/** Home, or the place nearest to it that the robot can get to. */
Eigen::Vector3d placeNearHome(const Mission& mission, const Plan& plan)
{
	const Eigen::Vector3d home = placeOf(*mission.map_from_home);
	if (plan.field.reaches(plan.home)) return home;
	CellIndex nearest = plan.start;
	const auto away = [&](CellIndex cell) { return (plan.map.middleOf(cell) - home).squaredNorm(); };
	for (CellIndex cell = 0; cell < plan.map.cells.size(); ++cell)
		if (plan.map.passable[cell] != 0 && plan.field.reaches(cell) && away(cell) < away(nearest)) nearest = cell;
	return plan.map.middleOf(nearest);
}

/** The way home, as it is now; how long it may take counts from when the robot first set out. */
MissionGoal goalHome(const Mission& mission, const Plan& plan, const MissionNow& now, const RobotConfig& robot)
{
	MissionGoal goal;
	goal.kind = GoalKind::home;
	goal.stand_in_map = goal.frontier_in_map = placeNearHome(mission, plan);
	goal.yaw_rad = yawOf(*mission.map_from_home);
	const bool on_its_way = mission.goal && mission.goal->kind == GoalKind::home;
	goal.chosen_at_s = on_its_way ? mission.goal->chosen_at_s : now.t_s;
	goal.patience_s =
	    on_its_way ? mission.goal->patience_s : kPatience_s + kPatience * pathHome(plan) / robot.max_speed_mps;
	return goal;
}

/** The target to go for, the current goal being one of them while it is worth keeping. */
void chooseTarget(Mission& mission, Plan& plan, const FrontierMemory& memory, const MissionNow& now,
                  const RobotConfig& robot, const MissionConfig& config)
{
	PickInput input{plan.map, plan.field, plan.targets, yawOf(now.map_from_robot), plan.home, std::nullopt};
	if (mission.goal)
	{
		std::erase_if(plan.targets, [&](const LookTarget& target)
		              { return (target.frontier_in_map - mission.goal->frontier_in_map).norm() < kSameGoal_m; });
		plan.targets.push_back(asTarget(*mission.goal, plan));
		input.current = plan.targets.size() - 1;
	}
	const bool tours = config.policy == GoalPolicy::explore;
	std::size_t pick = input.current.value_or(0);
	if (tours)
		pick = firstOfTour(input, robot, config.plan);
	else if (!input.current)
		pick = nearestTarget(plan.targets);
	if (input.current && (pick == *input.current || wasLeftLately(mission, plan.targets[pick], now.t_s))) return;
	if (mission.goal) leave(mission, now.t_s);
	mission.goal = goalFor(plan.targets[pick], plan, memory, now, robot);
}

/** Why the robot has to go home now although there is more to see. */
MissionEnd budgetSpent(const Mission& mission, const Plan& plan, const MissionNow& now, const RobotConfig& robot,
                       const MissionConfig& config)
{
	const double needed_m = pathHome(plan) * (1.0 + config.budget.reserve);
	const double needed_s = 2.0 * needed_m / robot.max_speed_mps;
	if (config.budget.time_s > 0.0 && now.t_s - mission.started_at_s + needed_s >= config.budget.time_s)
		return MissionEnd::time_budget;
	if (config.budget.path_m > 0.0 && mission.path_m + needed_m >= config.budget.path_m) return MissionEnd::path_budget;
	return MissionEnd::none;
}

void goHome(Mission& mission, MissionEnd why, const Plan& plan, const MissionNow& now, const RobotConfig& robot)
{
	mission.phase = MissionPhase::go_home;
	mission.end = why;
	mission.goal = goalHome(mission, plan, now, robot);
}

bool overBudget(const Mission& mission)
{
	return mission.end == MissionEnd::time_budget || mission.end == MissionEnd::path_budget;
}

void replan(Mission& mission, const FrontierMemory& memory, const MissionNow& now, const RobotConfig& robot,
            const MissionConfig& config)
{
	mission.planned_at_s = now.t_s;
	std::erase_if(mission.blocked, [&](const BlockedSpot& spot) { return spot.until_s < now.t_s; });
	Plan plan = planNow(mission, memory, now, robot, config);
	mission.open_frontiers = plan.targets.size();
	if (mission.goal && mission.goal->kind != GoalKind::home && !isWorthKeeping(*mission.goal, plan, config.plan))
	{
		mission.goal.reset();
		mission.goal_lost = true;
	}

	const MissionEnd spent = overBudget(mission) ? mission.end : budgetSpent(mission, plan, now, robot, config);
	const bool looking = mission.goal && mission.goal->kind != GoalKind::home;
	if (spent != MissionEnd::none)
		goHome(mission, spent, plan, now, robot);
	else if (plan.targets.empty() && !looking)
		goHome(mission, MissionEnd::nothing_left, plan, now, robot);
	else
	{
		if (mission.phase == MissionPhase::go_home) mission.goal.reset();
		mission.phase = MissionPhase::explore;
		mission.end = MissionEnd::none;
		chooseTarget(mission, plan, memory, now, robot, config);
	}
	if (mission.phase == MissionPhase::go_home)
		mission.left_over = leftOver({plan.map, memory, plan.field, plan.area, !overBudget(mission)});
	mission.way_in_map = shortenedWay(plan.map, plan.field, plan.map.cellOf(mission.goal->stand_in_map), config.plan);
	if (!mission.way_in_map.empty()) mission.way_in_map.back() = mission.goal->stand_in_map;
}

void count(Mission& mission, const MissionNow& now)
{
	const Eigen::Vector3d at = placeOf(now.map_from_robot);
	if (!mission.map_from_home)
	{
		mission.map_from_home = now.map_from_robot;
		mission.started_at_s = now.t_s;
	}
	if (mission.robot_in_map) mission.path_m += (at - *mission.robot_in_map).norm();
	mission.robot_in_map = at;
}
}  // namespace

std::string_view nameOf(MissionEnd end)
{
	static constexpr std::array<std::string_view, 4> kNames{"", "nothing reachable left", "time budget", "path budget"};
	return kNames.at(static_cast<std::size_t>(end));
}

void pursue(Mission& mission, const FrontierMemory& memory, const MissionNow& now, const RobotConfig& robot,
            const MissionConfig& config)
{
	count(mission, now);
	mission.goal_lost = false;
	if (mission.phase == MissionPhase::done) return;
	bool plans = now.t_s - mission.planned_at_s >= config.plan.period_s || !mission.goal;
	const bool reached = mission.goal && isReached(*mission.goal, now, config.plan);
	if (reached || (mission.goal && now.t_s - mission.goal->chosen_at_s > mission.goal->patience_s))
	{
		if (mission.goal->kind == GoalKind::home)
		{
			mission.phase = MissionPhase::done;
			return;
		}
		addTry(mission, *mission.goal, mission.goal->gain_m2);
		if (!reached) leave(mission, now.t_s);
		mission.goal.reset();
		plans = true;
	}
	if (plans) replan(mission, memory, now, robot, config);
}
}  // namespace explore
