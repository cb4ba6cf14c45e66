#include <explore/perception/perceive.h>
#include <explore/pipeline/explorer.h>
#include <mrpt/system/datetime.h>

namespace explore
{
namespace
{
/** The floor of this frame, else the last one that was seen. */
std::optional<Ground> groundToReport(const std::optional<Ground>& seen, std::optional<Ground> last)
{
	if (seen) return seen;
	if (last) last->seen = false;
	return last;
}

/** `sight` must outlive the result. */
AvoiderInput avoiderInput(const DepthFrame& frame, const SightLines& sight, const Percepts& percepts,
                          const GoalChoice& choice, const RobotConfig& robot)
{
	AvoiderInput input;
	input.sight = &sight;
	input.up_in_robot =
	    frame.up_in_robot.value_or(percepts.ground ? percepts.ground->plane.normal : Eigen::Vector3d::UnitZ());
	input.obstacles_in_robot = &percepts.obstacles_in_robot;
	input.sensor_in_robot = isometryOf(frame.robot_from_camera).translation();
	// A ground robot takes its floor along; a MAV has moved against the floor it saw earlier.
	if (percepts.ground && (percepts.ground->seen || robot.kind == RobotKind::ground))
		input.ground = percepts.ground->plane;
	input.desired_rad = choice.desired_rad;
	if (choice.goal.point_in_robot) input.goal_distance_m = choice.goal.point_in_robot->head<2>().norm();
	return input;
}

StopReason reasonToStop(const DepthFrame& frame, const Percepts& percepts, const ExplorerState& state,
                        const ExplorerConfig& config)
{
	if (percepts.near_field.valid_pixels < static_cast<std::size_t>(config.heading.min_valid_pixels))
		return StopReason::empty_frame;
	if (state.last_timestamp && frame.timestamp <= *state.last_timestamp) return StopReason::stale_frame;
	if (obstacleLost(state.guard)) return StopReason::near_obstacle_lost;
	return StopReason::none;
}

/** The speed that the robot still has: none after a gap in which its watchdog must have stopped it. */
double speedNow(const DepthFrame& frame, const ExplorerState& state, const HeadingConfig& config)
{
	if (!state.last_timestamp) return 0.0;
	const double gap_s = mrpt::system::timeDifference(*state.last_timestamp, frame.timestamp);
	return gap_s > config.max_frame_gap_s ? 0.0 : state.speed_mps;
}
}  // namespace

StepResult step(const DepthFrame& frame, ExplorerState& state, const ExplorerConfig& config, const StageEnded& ended)
{
	const auto done = [&](std::string_view stage)
	{
		if (ended) ended(stage);
	};
	StepResult result;

	result.percepts = perceive(frame, config.perception, config.robot, state.perception);  // lines 1–25
	result.percepts.ground = groundToReport(result.percepts.ground, state.last_ground);
	done("perceive");

	const GoalChoice choice = chooseGoal(result.percepts, config.robot, config.goal);  // lines 26–27: θ_o, θ_v → θ_d
	done("choose");

	const SightLines sight = sightLines(frame);
	const Avoidance avoidance = avoid(avoiderInput(frame, sight, result.percepts, choice, config.robot), config.robot,
	                                  config.avoider);  // line 28: θ_a
	done("avoid");

	state.guard = updateGuard(state.guard, result.percepts.near_field, config.perception.near_field.sensor_min_range_m,
	                          config.near_field_guard);
	const StopReason forbidden = reasonToStop(frame, result.percepts, state, config);
	result.decision =
	    decide(choice, avoidance, forbidden, speedNow(frame, state, config.heading), config.robot, config.heading);
	done("heading");

	state.last_ground = result.percepts.ground;
	if (!state.last_timestamp || frame.timestamp > *state.last_timestamp) state.last_timestamp = frame.timestamp;
	state.speed_mps = result.decision.command.velocity_mps.norm();
	return result;
}
}  // namespace explore
