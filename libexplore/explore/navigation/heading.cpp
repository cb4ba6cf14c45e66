#include <explore/navigation/heading.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
/** A robot that stands starts when this speed is safe (or half its top speed, if that is less), and one that drives
 *  stops when only half of it is: between the two lies more than the noise of an open path. */
constexpr double kStartSpeed_mps = 0.10;
constexpr double kCrawl = 0.5;

constexpr double kTurnTime_s = 0.5;
/** Full speed up to the one turn, a share of it from the other on: where a robot turns to, its hull passes what lies
 *  beside a camera's usual 57° of view, and somebody may have come there since it was last seen. Not none: a robot that
 *  sees a way to the left once it has turned right, and the other way round, would turn for ever. */
constexpr double kFullSpeed_rad = 0.1, kSharpTurn_rad = 0.5, kLeastShare = 0.25;

double brakingDistance(double speed_mps, const RobotConfig& robot)
{
	return speed_mps * speed_mps / (2.0 * robot.max_acceleration_mps2);
}

bool tooShort(double open_path_m, double current_speed_mps, const RobotConfig& robot, const HeadingConfig& config)
{
	const double start_mps = std::min(kStartSpeed_mps, 0.5 * robot.max_speed_mps);
	const double crawl_mps = kCrawl * start_mps;
	const double safe_mps = safeSpeed(open_path_m, robot, config);
	if (current_speed_mps < crawl_mps) return safe_mps < start_mps;
	return safe_mps < crawl_mps || open_path_m < brakingDistance(current_speed_mps, robot) + config.stop_margin_m;
}

StopReason stopReason(const Avoidance& avoidance, StopReason forbidden, double current_speed_mps,
                      const RobotConfig& robot, const HeadingConfig& config)
{
	if (forbidden != StopReason::none) return forbidden;
	if (!avoidance.heading_rad) return StopReason::no_direction;
	return tooShort(avoidance.open_path_m, current_speed_mps, robot, config) ? StopReason::path_too_short
	                                                                         : StopReason::none;
}

/** Share of the speed that is left in a turn. */
double speedInTurn(double turn_rad)
{
	const double sharp =
	    std::clamp((std::abs(turn_rad) - kFullSpeed_rad) / (kSharpTurn_rad - kFullSpeed_rad), 0.0, 1.0);
	return (1.0 - sharp * (1.0 - kLeastShare)) * std::max(0.0, std::cos(turn_rad));
}

Command commandFor(const Avoidance& avoidance, const RobotConfig& robot, const HeadingConfig& config)
{
	const double turn_rad = *avoidance.heading_rad;
	const double free_m = std::min(avoidance.open_path_m, avoidance.turning_path_m);
	const double speed_mps = safeSpeed(free_m, robot, config) * speedInTurn(turn_rad);
	Command command;
	command.velocity_mps.x() = speed_mps * std::cos(avoidance.elevation_rad);
	command.velocity_mps.z() = speed_mps * std::sin(avoidance.elevation_rad);
	command.yaw_rate_radps = std::clamp(turn_rad / kTurnTime_s, -robot.max_yaw_rate_radps, robot.max_yaw_rate_radps);
	return command;
}
}  // namespace

void describe(FieldVisitor& fields, HeadingConfig& config)
{
	fields.section("heading", "Speed and stop");
	fields.real("stop_margin", config.stop_margin_m, {0.0, 2.0}, "m", "kept free in front of the hull after braking");
	fields.real("reaction_time", config.reaction_time_s, {0.0, 5.0}, "s",
	            "reserve before braking: twice the delay from measuring to moving, plus two frames");
	fields.real("max_frame_gap", config.max_frame_gap_s, {0.01, 60.0}, "s",
	            "a robot that waits longer for a frame must stop");
	fields.integer("min_valid_pixels", config.min_valid_pixels, {0, 1e7}, "pixels",
	               "a frame with fewer valid measurements is empty, and the robot stops");
}

double stoppingDistance(double speed_mps, const RobotConfig& robot, const HeadingConfig& config)
{
	return brakingDistance(speed_mps, robot) + speed_mps * config.reaction_time_s + config.stop_margin_m;
}

double safeSpeed(double open_path_m, const RobotConfig& robot, const HeadingConfig& config)
{
	const double free_m = open_path_m - config.stop_margin_m;
	if (!(free_m > 0.0)) return 0.0;
	const double reaction_s = config.reaction_time_s;
	// The positive root of v²/2a + v·reaction = free, in the form that keeps its digits when free is small.
	const double root = std::sqrt(reaction_s * reaction_s + 2.0 * free_m / robot.max_acceleration_mps2);
	return std::min(2.0 * free_m / (reaction_s + root), robot.max_speed_mps);
}

Decision decide(const GoalChoice& choice, const Avoidance& avoidance, StopReason forbidden, double current_speed_mps,
                const RobotConfig& robot, const HeadingConfig& config)
{
	Decision decision;
	decision.goal = choice.goal;
	decision.headings.door_rad = choice.door_rad;
	decision.headings.vanishing_point_rad = choice.vanishing_point_rad;
	decision.headings.desired_rad = choice.desired_rad;
	if (avoidance.deviates) decision.headings.avoid_rad = avoidance.heading_rad;
	decision.open_path_m = avoidance.open_path_m;
	decision.stop_reason = stopReason(avoidance, forbidden, current_speed_mps, robot, config);
	decision.stop = decision.stop_reason != StopReason::none;
	if (decision.stop) return decision;
	decision.headings.chosen_rad = avoidance.heading_rad;
	decision.headings.chosen_elevation_rad = avoidance.elevation_rad;
	decision.command = commandFor(avoidance, robot, config);
	return decision;
}

void slowFor(Decision& decision, double rest_m, const RobotConfig& robot, const HeadingConfig& config)
{
	const double speed_mps = decision.command.velocity_mps.norm();
	const double most_mps = safeSpeed(rest_m + config.stop_margin_m, robot, config);
	if (speed_mps > most_mps) decision.command.velocity_mps *= most_mps / speed_mps;
}
}  // namespace explore
