#include <explore/pipeline/intent.h>

namespace explore
{
namespace
{
/** What a look around would show if it showed all that is confirmed. */
Percepts remembered(const Percepts& percepts, const FrontierMemory& memory, const Eigen::Isometry3d& robot_from_map)
{
	Percepts known;
	known.ground = percepts.ground;
	known.doors = confirmedDoors(memory.doors, robot_from_map);
	known.vanishing_points = confirmedCorridors(memory.corridors, robot_from_map);
	return known;
}

Goal goalOf(const Mission& mission, const Eigen::Isometry3d& robot_from_map)
{
	if (!mission.goal) return {};
	return {mission.goal->kind, mission.goal->track, Eigen::Vector3d(robot_from_map * mission.goal->stand_in_map)};
}
}  // namespace

Intent intend(const DepthFrame& frame, const Percepts& percepts, const FrontierMemory* memory, Mission& mission,
              Steering& steering, const ExplorerConfig& config)
{
	Intent intent;
	if (memory == nullptr)
	{
		intent.choice = chooseGoal(percepts, config.robot);
		intent.steering.desired_rad = intent.choice.desired_rad;
		return intent;
	}
	const MissionNow now{isometryOf(frame.map_from_robot), mrpt::Clock::toDouble(frame.timestamp)};
	const Eigen::Isometry3d robot_from_map = now.map_from_robot.inverse();
	const bool tracks = config.memory.tracks;
	intent.choice = chooseGoal(tracks ? remembered(percepts, *memory, robot_from_map) : percepts, config.robot);
	intent.steering.desired_rad = intent.choice.desired_rad;
	if (config.mission.policy == GoalPolicy::paper) return intent;

	pursue(mission, *memory, now, config.robot, config.mission);
	intent.finished = mission.phase == MissionPhase::done;
	intent.choice.goal = intent.finished ? Goal{} : goalOf(mission, robot_from_map);
	intent.steering = steer(steering, mission, *memory, now, config.robot);
	intent.choice.desired_rad = intent.steering.desired_rad;
	intent.may_move_blindly = mayMoveBlindly(steering, now.t_s);
	return intent;
}
}  // namespace explore
