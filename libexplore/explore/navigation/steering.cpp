#include <explore/core/geometry.h>
#include <explore/navigation/steering.h>
#include <explore/navigation/way_ahead.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace explore
{
namespace
{
/** How far ahead on the way the robot aims. */
constexpr double kAhead_m = 0.5;
/** It turns on the spot from the one on, until the other. */
constexpr double kTurnFrom_rad = 0.6, kTurnUntil_rad = 0.15;
constexpr double kTurnTime_s = 0.5;
/** Blocked for so long, it backs off so far, so fast; the spot ahead is avoided for a while. */
constexpr double kWait_s = 2.0, kBackOff_m = 0.25, kBackOff_mps = 0.15, kAvoidSpot_s = 20.0;
/** Each time that it is blocked near such a spot it backs off twice as far, but so often at most, and keeps off longer.
 */
constexpr double kSameSpot_m = 0.6;
constexpr std::ptrdiff_t kMostDoublings = 2;
/** A robot that drives gets this far within its patience. */
constexpr double kHeadway_m = 0.05;
/** It turns back to where it was so far from here. */
constexpr double kBack_m = 0.7;
/** It moves by what it remembers when the camera has shown nothing for so long, but for no longer than the other. */
constexpr double kDark_s = 1.0, kBlind_s = 15.0;

/** Whether the hull has known free room straight behind it. */
bool isFreeBehind(const BodyLayers& layers, const MissionNow& now, const RobotConfig& robot)
{
	const LayerFrame& frame = layers.frame();
	const Eigen::Vector3d at = now.map_from_robot.translation();
	const Eigen::Vector2d back = -now.map_from_robot.linear().col(0).head<2>().normalized();
	const Eigen::Vector2d side(-back.y(), back.x());
	const double reach_m = robot.radius_m + kBackOff_m + 0.5 * frame.resolution_m;
	for (double along = 0.5 * robot.radius_m; along <= reach_m; along += 0.5 * frame.resolution_m)
		for (double across = -robot.radius_m; across <= robot.radius_m; across += 0.5 * frame.resolution_m)
		{
			const Eigen::Vector2d point = at.head<2>() + along * back + across * side;
			const LayerCell cell = frame.cellAt(point, frame.nearestLayer(at.z()));
			if (layers.stateOf(cell) != CellState::free) return false;
		}
	return true;
}

/** How often it was blocked near there lately, up to now. */
std::ptrdiff_t blockAhead(Mission& mission, const MissionNow& now)
{
	const Eigen::Vector3d ahead = aimOn(mission.way_in_map, now.map_from_robot.translation(), kAhead_m).point_in_map;
	const auto times =
	    std::count_if(mission.blocked.begin(), mission.blocked.end(),
	                  [&](const BlockedSpot& spot) { return (spot.at_in_map - ahead).norm() < kSameSpot_m; });
	mission.blocked.push_back(
	    {ahead, now.t_s + kAvoidSpot_s * static_cast<double>(1 + std::min(times, kMostDoublings))});
	mission.planned_at_s = 0.0;
	return times;
}

/** Whether the robot drives, and gets nowhere: it has run into something that it does not see. */
bool isHeld(Steering& steering, const MissionNow& now)
{
	const Eigen::Vector3d at = now.map_from_robot.translation();
	if (!steering.driving || (at - steering.got_to_in_map).norm() > kHeadway_m)
	{
		steering.got_to_in_map = at;
		steering.got_there_at_s = now.t_s;
	}
	return now.t_s - steering.got_there_at_s > kWait_s;
}

/** Whether the robot has had no way for a while. */
bool isStuck(Steering& steering, const MissionNow& now)
{
	const bool held = isHeld(steering, now);
	return held || (steering.blocked_since_s && now.t_s - *steering.blocked_since_s >= kWait_s);
}

/** Whether the robot is backing off in this frame. */
bool backsOff(Steering& steering, Mission& mission, const FrontierMemory& memory, const MissionNow& now,
              const RobotConfig& robot)
{
	const Eigen::Vector3d at = now.map_from_robot.translation();
	const bool free_behind = isFreeBehind(memory.layers, now, robot);
	if (steering.backing_from_in_map)
	{
		if (free_behind && (at - *steering.backing_from_in_map).norm() < steering.back_off_m) return true;
		steering.backing_from_in_map.reset();
		return false;
	}
	if (!isStuck(steering, now)) return false;
	steering.blocked_since_s.reset();
	steering.got_there_at_s = now.t_s;
	const std::ptrdiff_t times = blockAhead(mission, now);
	steering.back_off_m = kBackOff_m * static_cast<double>(1 << std::min(times, kMostDoublings));
	if (free_behind) steering.backing_from_in_map = at;
	return free_behind;
}

/** Where the robot has come from, robot frame. */
double bearingBack(const Mission& mission, const MissionNow& now)
{
	const Eigen::Isometry3d robot_from_map = now.map_from_robot.inverse();
	const auto last = std::find_if(mission.trail_in_map.rbegin(), mission.trail_in_map.rend(),
	                               [&](const Eigen::Vector3d& place)
	                               { return (robot_from_map * place).head<2>().norm() >= kBack_m; });
	return last == mission.trail_in_map.rend() ? std::numbers::pi : azimuthOf(robot_from_map * *last);
}

/** A robot that is to drive on but has come too near to something to see turns back to where it came from, and gives
 *  the goal up. */
void turnBack(Steering& steering, Mission& mission, const MissionNow& now, SteeringGoal& goal)
{
	goal.turns = true;
	goal.desired_rad = bearingBack(mission, now);
	if (std::exchange(steering.turning_back, true)) return;
	blockAhead(mission, now);
	if (mission.goal->kind != GoalKind::home) mission.goal->patience_s = 0.0;
}

/** On the spot, or not, with hysteresis. */
bool turns(Steering& steering, double bearing_rad, double until_rad)
{
	const double away_rad = std::abs(bearing_rad);
	steering.turning = steering.turning ? away_rad > until_rad : away_rad > kTurnFrom_rad;
	return steering.turning;
}
}  // namespace

SteeringGoal steer(Steering& steering, Mission& mission, const FrontierMemory& memory, const MissionNow& now,
                   const RobotConfig& robot)
{
	SteeringGoal goal;
	if (!mission.goal) return goal;
	goal.backs_off = backsOff(steering, mission, memory, now, robot);
	if (goal.backs_off)
	{
		goal.desired_rad = std::numbers::pi;
		return goal;
	}
	const Eigen::Isometry3d robot_from_map = now.map_from_robot.inverse();
	const Aim aim = aimOn(mission.way_in_map, now.map_from_robot.translation(), kAhead_m);
	goal.goal_distance_m = aim.rest_m;
	const double away_m = (robot_from_map * mission.goal->stand_in_map).head<2>().norm();
	const bool there = away_m < (mission.goal->kind == GoalKind::home ? 0.04 : 0.10) || mission.way_in_map.empty();
	const Eigen::Vector3d facing(std::cos(mission.goal->yaw_rad), std::sin(mission.goal->yaw_rad), 0.0);
	const Eigen::Vector3d toward = there ? robot_from_map.linear() * facing : robot_from_map * aim.point_in_map;
	goal.desired_rad = azimuthOf(toward);
	goal.turns = there || turns(steering, goal.desired_rad, kTurnUntil_rad);
	// Begun, it is done: a turn toward the next goal would end where it sees nothing again.
	if ((steering.turning_back || !goal.turns) && mayMoveBlindly(steering, now.t_s))
		turnBack(steering, mission, now, goal);
	if (robot.kind == RobotKind::mav && !there)
		goal.desired_elevation_rad = std::atan2(toward.z(), std::max(0.2, toward.head<2>().norm()));
	return goal;
}

Decision manoeuvre(const GoalChoice& choice, const SteeringGoal& goal, const RobotConfig& robot)
{
	Decision decision;
	decision.goal = choice.goal;
	decision.headings.door_rad = choice.door_rad;
	decision.headings.vanishing_point_rad = choice.vanishing_point_rad;
	decision.headings.desired_rad = decision.headings.chosen_rad = goal.desired_rad;
	if (goal.backs_off)
	{
		decision.goal.kind = GoalKind::recover;
		decision.command.velocity_mps.x() = -std::min(kBackOff_mps, robot.max_speed_mps);
		return decision;
	}
	decision.command.yaw_rate_radps =
	    std::clamp(goal.desired_rad / kTurnTime_s, -robot.max_yaw_rate_radps, robot.max_yaw_rate_radps);
	return decision;
}

bool mayMoveBlindly(const Steering& steering, double t_s)
{
	if (!steering.blind_since_s) return false;
	const double blind_s = t_s - *steering.blind_since_s;
	return blind_s >= kDark_s && blind_s < kBlind_s;
}

void noteDecision(Steering& steering, const Decision& decision, bool frame_is_empty, double t_s)
{
	if (!frame_is_empty)
	{
		steering.blind_since_s.reset();
		steering.turning_back = false;
	}
	else if (!steering.blind_since_s)
		steering.blind_since_s = t_s;
	steering.driving = decision.command.velocity_mps.x() > 0.0;
	const StopReason why = decision.stop_reason;
	const bool too_near = why == StopReason::empty_frame && mayMoveBlindly(steering, t_s);
	const bool no_way = why == StopReason::path_too_short || why == StopReason::no_direction || too_near;
	if (!no_way)
		steering.blocked_since_s.reset();
	else if (!steering.blocked_since_s)
		steering.blocked_since_s = t_s;
}
}  // namespace explore
