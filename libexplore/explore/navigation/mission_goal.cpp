#include <explore/navigation/goal_kind.h>
#include <explore/navigation/mission_goal.h>
#include <explore/navigation/mission_plan.h>

namespace explore
{
namespace
{
/** How long a goal may take: so many times as long as the way at full speed, and a while to turn and wait. */
constexpr double kPatience = 4.0, kPatience_s = 30.0;
/** On the way home that while is longer: there is nothing else to do than to wait until the way is free. */
constexpr double kPatienceHome_s = 120.0;
}  // namespace

MissionGoal goalFor(const LookTarget& target, const MissionPlan& plan, const FrontierMemory& memory, double now_s,
                    const RobotConfig& robot)
{
	MissionGoal goal;
	goal.stand_in_map = target.stand_in_map;
	goal.frontier_in_map = target.frontier_in_map;
	goal.yaw_rad = target.look.yaw_rad;
	goal.gain_m2 = target.gain_m2;
	goal.pocket_m2 = target.pocket_m2;
	goal.purpose = target.purpose;
	goal.chosen_at_s = now_s;
	goal.patience_s = kPatience_s + kPatience * target.travel_m / robot.max_speed_mps;
	const GoalName name = nameOf(target, plan.field.wayTo(target.look.cell), plan.map, memory, robot);
	goal.kind = name.kind;
	goal.track = name.track;
	return goal;
}

MissionGoal goalHome(const Mission& mission, const MissionPlan& plan, double now_s, const RobotConfig& robot)
{
	MissionGoal goal;
	goal.kind = GoalKind::home;
	const HomePlace place = homePlace(mission, plan);
	goal.stand_in_map = goal.frontier_in_map = place.stand_in_map;
	goal.yaw_rad = place.yaw_rad;
	goal.reachable = plan.field.reaches(plan.home);
	const bool on_its_way = mission.goal && mission.goal->kind == GoalKind::home;
	goal.chosen_at_s = on_its_way ? mission.goal->chosen_at_s : now_s;
	goal.patience_s =
	    on_its_way ? mission.goal->patience_s : kPatienceHome_s + kPatience * pathHome(plan) / robot.max_speed_mps;
	return goal;
}

void standForTargets(MissionGoal& goal, std::vector<LookTarget>& targets)
{
	std::optional<double> pocket_m2;
	std::erase_if(targets,
	              [&](const LookTarget& target)
	              {
		              const bool same = (target.frontier_in_map - goal.frontier_in_map).norm() < kSameGoal_m;
		              if (same) pocket_m2 = pocket_m2.value_or(0.0) + target.pocket_m2;
		              return same;
	              });
	goal.pocket_m2 = pocket_m2.value_or(goal.pocket_m2);
}
}  // namespace explore
