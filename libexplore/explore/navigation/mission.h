// What the robot is up to from its first frame to the last: the goal it goes for, the way there, and when it is done.
#pragma once

#include <explore/core/results.h>
#include <explore/memory/frontier_memory.h>
#include <explore/navigation/left_over.h>
#include <explore/navigation/look_targets.h>
#include <explore/navigation/mission_config.h>

#include <Eigen/Geometry>
#include <optional>
#include <string_view>
#include <vector>

namespace explore
{
enum class MissionPhase
{
	explore,
	go_home,
	done,
};

/** Why the robot went home. */
enum class MissionEnd
{
	none,
	nothing_left,
	time_budget,
	path_budget,
	cut_off,  ///< nothing is left that a way leads to, but none leads home either, or anywhere
};
[[nodiscard]] std::string_view nameOf(MissionEnd end);

/** A place to go to and the way to look there. */
struct MissionGoal
{
	GoalKind kind = GoalKind::none;
	std::optional<int> track;                                   ///< of a door or corridor that the way leads through
	Eigen::Vector3d stand_in_map = Eigen::Vector3d::Zero();     ///< where the robot is to be
	Eigen::Vector3d frontier_in_map = Eigen::Vector3d::Zero();  ///< what it is to see there
	double yaw_rad = 0;                                         ///< in the map
	double gain_m2 = 0;                                         ///< unknown space that it is held to show
	double pocket_m2 = 0;                                       ///< LookTarget::pocket_m2
	LookPurpose purpose = LookPurpose::frontier;
	bool reachable = true;                   ///< false: home, to which no way leads at present
	double chosen_at_s = 0, patience_s = 0;  ///< when, and how long it may take
	double chosen_at_m = 0;                  ///< of the path
	std::optional<double> waits_since_s;     ///< there, for a barred way to become free
};

/** A goal that was given up for another, and when: the robot does not turn back to it soon. */
struct LeftGoal
{
	Eigen::Vector3d stand_in_map = Eigen::Vector3d::Zero();
	double at_s = 0;
};

/** A frontier that was looked at, or could not be reached, and stayed: it is tried again when it has changed. */
struct TriedFrontier
{
	Eigen::Vector3d frontier_in_map = Eigen::Vector3d::Zero();
	double gain_m2 = 0;
	int tries = 0;
};

/** A frontier that could be got at, and places on the way to it, from the robot on. */
struct OpenWay
{
	Eigen::Vector3d frontier_in_map = Eigen::Vector3d::Zero();
	std::vector<Eigen::Vector3d> places_in_map;
};

struct OpenWays
{
	std::vector<OpenWay> ways;
	int waits = 0;  ///< before what bars some of them, since a look last showed a frontier
};

/** A spot where the avoider found no way although the plan had one: plans keep off it for a while. */
struct BlockedSpot
{
	Eigen::Vector3d at_in_map = Eigen::Vector3d::Zero();
	double until_s = 0;
};

/** All that is carried from frame to frame. */
struct Mission
{
	MissionPhase phase = MissionPhase::explore;
	MissionEnd end = MissionEnd::none;
	std::optional<Eigen::Isometry3d> map_from_home;  ///< where the robot was in the first frame
	double started_at_s = 0, planned_at_s = 0;
	std::optional<Eigen::Vector3d> robot_in_map;  ///< in the last frame
	double last_at_s = 0;                         ///< when that was
	double path_m = 0;
	std::vector<Eigen::Vector3d> trail_in_map;  ///< where the robot has been
	bool home_reached = false;
	bool held = false;  ///< it has not moved since before it gave its last goal up
	std::optional<MissionGoal> goal;
	bool goal_lost = false;                   ///< in this frame, by what the map newly shows
	std::vector<Eigen::Vector3d> way_in_map;  ///< corners, from the robot to the goal
	std::vector<LeftGoal> left;               ///< lately, done or not
	bool undone = false;                      ///< the last of them
	std::vector<TriedFrontier> tried;
	std::vector<BlockedSpot> blocked;
	OpenWays open_ways;
	std::vector<LeftOver> left_over;  ///< of the last plan that found nothing to do
	std::size_t open_frontiers = 0;   ///< that the last plan would have gone to
};

/** Where the robot is, and when. */
struct MissionNow
{
	Eigen::Isometry3d map_from_robot = Eigen::Isometry3d::Identity();
	double t_s = 0;  ///< mrpt::Clock::toDouble
};

/** Chooses, keeps and drops goals, and plans the way. Same memory, same mission, same plan. */
void pursue(Mission& mission, const FrontierMemory& memory, const MissionNow& now, const RobotConfig& robot,
            const MissionConfig& config);
}  // namespace explore
