#include <explore/navigation/map_obstacles.h>
#include <explore/perception/perceive.h>
#include <explore/pipeline/explorer.h>
#include <explore/pipeline/intent.h>
#include <mrpt/system/datetime.h>

#include <algorithm>
#include <optional>

namespace explore
{
namespace
{
/** The avoider asks the map this far around the robot. */
constexpr double kAround_m = 2.0;

/** The floor of this frame, else the last one that was seen. */
std::optional<Ground> groundToReport(const std::optional<Ground>& seen, std::optional<Ground> last)
{
	if (seen) return seen;
	if (last) last->seen = false;
	return last;
}

/** The memory that this frame is fused into: none without a pose, which says where it belongs. */
FrontierMemory* memoryFor(const DepthFrame& frame, ExplorerState& state, const ExplorerConfig& config)
{
	const bool fuses = config.memory.enabled && config.perception.method == PerceptionMethod::full;
	if (!fuses || frame.pose_origin == PoseOrigin::none) return nullptr;
	if (!state.memory) state.memory = std::make_unique<FrontierMemory>(config.memory, config.robot);
	return state.memory.get();
}

/** Whether the map says what was never seen. A robot that has not planned to look there first, as the paper's, would
 *  not get away from where it starts: the lines of sight of its frame say it instead. */
bool isUnknownMapped(const FrontierMemory* memory, const ExplorerConfig& config)
{
	return memory != nullptr && config.mission.policy != GoalPolicy::paper;
}

void append(PointCloud& all, const PointCloud& more)
{
	for (std::size_t i = 0; i < more.size(); ++i) all.push_back(more[i]);
}

/** What may stand too near to be measured counts as an obstacle. The camera of a MAV may look where no floor returns.
 */
void addHidden(Percepts& percepts, const DepthFrame& frame, const ExplorerConfig& config)
{
	if (config.robot.kind == RobotKind::mav) return;
	append(percepts.obstacles_in_robot, hiddenNear(frame, percepts.near_field, config.perception.near_field));
}

/** What stands around the robot: as this frame shows it, as its other sensors do, and as the memory has it. */
PointCloud obstaclesAround(const DepthFrame& frame, const Percepts& percepts, const FrontierMemory* memory,
                           const ExplorerConfig& config)
{
	PointCloud all = percepts.obstacles_in_robot;
	append(all, frame.more_obstacles_in_robot);
	if (memory == nullptr) return all;
	const Eigen::Isometry3d map_from_robot = isometryOf(frame.map_from_robot);
	append(all, mapObstacles(memory->layers, map_from_robot, config.robot, kAround_m, isUnknownMapped(memory, config)));
	append(all, inRobotFrame(memory->recent, map_from_robot));
	return all;
}

/** `sight` and `obstacles` must outlive the result. Without `sight` the obstacles say what was not seen. */
AvoiderInput avoiderInput(const DepthFrame& frame, const SightLines* sight, const PointCloud& obstacles,
                          const Percepts& percepts, const Intent& intent, const RobotConfig& robot)
{
	AvoiderInput input;
	input.sight = sight;
	input.up_in_robot =
	    frame.up_in_robot.value_or(percepts.ground ? percepts.ground->plane.normal : Eigen::Vector3d::UnitZ());
	input.obstacles_in_robot = &obstacles;
	input.sensor_in_robot = isometryOf(frame.robot_from_camera).translation();
	// A ground robot takes its floor along; a MAV has moved against the floor it saw earlier.
	if (percepts.ground && (percepts.ground->seen || robot.kind == RobotKind::ground))
		input.ground = percepts.ground->plane;
	input.desired_rad = intent.choice.desired_rad;
	input.desired_elevation_rad = intent.steering.desired_elevation_rad;
	input.goal_distance_m = intent.steering.goal_distance_m;
	return input;
}

StopReason reasonOf(RobotHalt halt)
{
	switch (halt)
	{
		case RobotHalt::bumper:
			return StopReason::bumper;
		case RobotHalt::cliff:
			return StopReason::cliff;
		case RobotHalt::link_lost:
			return StopReason::link_lost;
		case RobotHalt::none:
			break;
	}
	return StopReason::none;
}

StopReason reasonToStop(const DepthFrame& frame, const Percepts& percepts, const FrontierMemory* memory,
                        const ExplorerState& state, const ExplorerConfig& config)
{
	if (frame.halt != RobotHalt::none) return reasonOf(frame.halt);
	if (percepts.near_field.valid_pixels < static_cast<std::size_t>(config.heading.min_valid_pixels))
		return StopReason::empty_frame;
	if (state.last_timestamp && frame.timestamp <= *state.last_timestamp) return StopReason::stale_frame;
	// The map remembers what slipped under the sensor's range.
	if (memory == nullptr && obstacleLost(state.guard)) return StopReason::near_obstacle_lost;
	return StopReason::none;
}

/** The speed that the robot still has: none after a gap in which its watchdog must have stopped it. */
double speedNow(const DepthFrame& frame, const ExplorerState& state, const HeadingConfig& config)
{
	if (!state.last_timestamp) return 0.0;
	const double gap_s = mrpt::system::timeDifference(*state.last_timestamp, frame.timestamp);
	return gap_s > config.max_frame_gap_s ? 0.0 : state.speed_mps;
}

/** How far it is to where the robot has to come to a stop, whatever comes then; no value where it may roll on. */
std::optional<double> distanceToStop(const Intent& intent, const RobotConfig& robot)
{
	const double along_way_m = intent.steering.goal_distance_m;
	// At home the run ends, and nobody corrects what a late command lets the robot roll on.
	const Goal& goal = intent.choice.goal;
	if (goal.kind == GoalKind::home && goal.point_in_robot)
		return std::max(along_way_m, goal.point_in_robot->head<2>().norm());
	// What flies drifts on where it is to turn.
	return robot.kind == RobotKind::mav && along_way_m > 0.0 ? std::optional(along_way_m) : std::nullopt;
}

/** A turn on the spot and a step back need no view of what is ahead; all else is stopped by what forbids it. */
Decision decideOn(const Intent& intent, const Avoidance& avoidance, StopReason forbidden, double speed_mps,
                  const ExplorerConfig& config)
{
	if (intent.finished) forbidden = StopReason::finished;
	const bool manoeuvres = intent.steering.turns || intent.steering.backs_off;
	const bool in_the_dark = forbidden == StopReason::empty_frame && intent.may_move_blindly;
	if (manoeuvres && (forbidden == StopReason::none || in_the_dark))
		return manoeuvre(intent.choice, intent.steering, config.robot);
	Decision decision = decide(intent.choice, avoidance, forbidden, speed_mps, config.robot, config.heading);
	if (const auto rest_m = distanceToStop(intent, config.robot))
		slowFor(decision, *rest_m, config.robot, config.heading);
	return decision;
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

	FrontierMemory* const memory = memoryFor(frame, state, config);
	if (memory != nullptr)
	{
		addHidden(result.percepts, frame, config);
		remember(*memory, frame, result.percepts, config.robot, config.memory);
	}
	done("remember");

	const Intent intent =
	    intend(frame, result.percepts, memory, state.mission, state.steering, config);  // lines 26–27: θ_o, θ_v → θ_d
	result.finished = intent.finished;
	done("choose");

	const SightLines sight = sightLines(frame);
	const PointCloud obstacles = obstaclesAround(frame, result.percepts, memory, config);
	const Avoidance avoidance = avoid(avoiderInput(frame, isUnknownMapped(memory, config) ? nullptr : &sight, obstacles,
	                                               result.percepts, intent, config.robot),
	                                  config.robot, config.avoider);  // line 28: θ_a
	done("avoid");

	state.guard = updateGuard(state.guard, result.percepts.near_field, config.perception.near_field.sensor_min_range_m,
	                          config.near_field_guard);
	const StopReason forbidden = reasonToStop(frame, result.percepts, memory, state, config);
	result.decision = decideOn(intent, avoidance, forbidden, speedNow(frame, state, config.heading), config);
	noteDecision(state.steering, result.decision, forbidden == StopReason::empty_frame,
	             mrpt::Clock::toDouble(frame.timestamp));
	done("heading");

	state.last_ground = result.percepts.ground;
	if (!state.last_timestamp || frame.timestamp > *state.last_timestamp) state.last_timestamp = frame.timestamp;
	state.speed_mps = result.decision.command.velocity_mps.norm();
	return result;
}
}  // namespace explore
