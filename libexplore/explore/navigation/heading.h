// From the avoider's direction to the heading, the speed and the stop.
#pragma once

#include <explore/navigation/avoider.h>
#include <explore/navigation/goal_choice.h>

namespace explore
{
struct HeadingConfig
{
	double stop_margin_m = 0.10;  ///< kept free in front of the hull after braking
	double reaction_time_s =
	    0.3;  ///< reserve before braking: twice the delay from measuring to moving, plus two frames
	double max_frame_gap_s = 0.5;  ///< a robot that waits longer for a frame must stop
	int min_valid_pixels = 500;    ///< fewer valid measurements (of an image or cloud) = empty frame
};
/** [heading] */
void describe(FieldVisitor& fields, HeadingConfig& config);

/** Free path that a robot at `speed_mps` needs: v²/2a + v·reaction + margin [m]. */
double stoppingDistance(double speed_mps, const RobotConfig& robot, const HeadingConfig& config);

/** The highest speed [m/s] whose stoppingDistance fits into `open_path_m`, at most the robot's; 0 when none does. */
double safeSpeed(double open_path_m, const RobotConfig& robot, const HeadingConfig& config);

/** Headings, open path, stop and command. `forbidden` (other than none) stops the robot whatever the avoider found;
 *  `current_speed_mps` is what the robot drives now.
 *
 *  The robot stops (path_too_short) when the open path is shorter than v²/2a + margin, when the speed that is safe has
 *  come down to a crawl, or, when it stands, until that speed is worth starting for: so it neither creeps for ever nor
 *  starts and stops by turns. Driving, the speed is the safe one for the shorter of the chosen way and of what the hull
 *  meets while it turns there, times the cosine of the turn; it keeps the reaction time in reserve, so that a robot
 * that follows it brakes gently and never comes to the stop rule. The yaw rate would end the turn in 0.5 s, within the
 *  robot's limit. */
Decision decide(const GoalChoice& choice, const Avoidance& avoidance, StopReason forbidden, double current_speed_mps,
                const RobotConfig& robot, const HeadingConfig& config);

/** No faster than it can stop within `rest_m`, by braking where its goal is. */
void slowFor(Decision& decision, double rest_m, const RobotConfig& robot, const HeadingConfig& config);
}  // namespace explore
