// From the way that is planned to what the avoider is asked for: a direction, or a turn on the spot, or backing off.
#pragma once

#include <explore/core/results.h>
#include <explore/navigation/heading.h>
#include <explore/navigation/mission.h>

#include <optional>

namespace explore
{
/** What is carried from frame to frame while the robot follows its way. */
struct Steering
{
	bool turning = false;                                     ///< on the spot
	std::optional<double> blocked_since_s;                    ///< the avoider has found no way since
	std::optional<Eigen::Vector3d> backing_from_in_map;       ///< where the robot was when it began to back off
	double back_off_m = 0;                                    ///< how far it goes back from there
	std::optional<double> blind_since_s;                      ///< the camera has shown nothing since
	bool turning_back = false;                                ///< to where it came from, and saw something
	bool driving = false;                                     ///< the last command was to drive
	Eigen::Vector3d got_to_in_map = Eigen::Vector3d::Zero();  ///< where it was when it last made headway …
	double got_there_at_s = 0;                                ///< … and when
};

/** What the robot is to do, robot frame. */
struct SteeringGoal
{
	double desired_rad = 0;            ///< θ_d
	double desired_elevation_rad = 0;  ///< MAV only
	double goal_distance_m = 0;        ///< along the way
	bool turns = false;                ///< on the spot, to desired_rad
	bool backs_off = false;            ///< straight back, what is behind being known and free
};

/** Where to go from here on the mission's way: toward a point a little ahead on it, turning on the spot where that lies
 *  far from straight ahead, and at its end to the goal's yaw. After more than a moment without a way the robot backs
 *  off along what it knows to be free, the spot ahead is blocked for the plan, and the plan is made anew. Stopped there
 *  again soon it backs off farther: who wants to come through where it wants to go out is let through. */
SteeringGoal steer(Steering& steering, Mission& mission, const FrontierMemory& memory, const MissionNow& now,
                   const RobotConfig& robot);

/** The decision of a robot that turns on the spot or backs off: its hull is round, so that turning needs no room. */
Decision manoeuvre(const GoalChoice& choice, const SteeringGoal& goal, const RobotConfig& robot);

/** Whether the robot may turn and back off by what it remembers although the camera shows nothing: it has shown
 *  nothing for a while, so that the robot may have come too near to something; a camera that stays dark is another
 *  matter. */
[[nodiscard]] bool mayMoveBlindly(const Steering& steering, double t_s);

/** Takes note of whether the robot could go where it wanted, and of what the camera shows. */
void noteDecision(Steering& steering, const Decision& decision, bool frame_is_empty, double t_s);
}  // namespace explore
