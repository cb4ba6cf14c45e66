// A robot that follows its mission through a drawn building and sees what its camera would show: no noise, no inertia.
#pragma once

#include <explore/navigation/mission.h>

#include <string>
#include <vector>

#include "support/drawn_map.h"

namespace explore::test
{
/** What is really there ('#' things, '~' glass and the like: nothing ever comes back from behind or of it), and a robot
 *  in it. */
class MissionRun
{
public:
	/** The robot starts at the mark 'r', looking along x. */
	MissionRun(const DrawnMap& world, const MissionConfig& config);

	/** Half a second: looks, thinks, moves. */
	void tick();
	/** Until it is done, or so much time has passed. */
	void run(double seconds);
	/** The world changes before the robot's eyes, or behind its back. */
	void change(const DrawnMap& world) { m_world = world; }

	[[nodiscard]] const Mission& mission() const { return m_mission; }
	[[nodiscard]] bool done() const { return m_mission.phase == MissionPhase::done; }
	[[nodiscard]] const Eigen::Vector3d& robot() const { return m_at; }
	[[nodiscard]] double seconds() const { return m_t_s - 1000.0; }
	[[nodiscard]] double path_m() const { return m_path_m; }
	/** The least distance to the middle of anything that stands there, at any time. */
	[[nodiscard]] double leastClearance_m() const { return m_clearance_m; }
	/** Characters of the world that are free, may be known, and are not. */
	[[nodiscard]] std::size_t freeButUnknown() const;
	/** Goals that were given up for another though nothing spoke against them, to be taken up again. */
	[[nodiscard]] int flips() const { return m_flips; }

private:
	void look();
	void move();
	void noteGoal();
	void advance(double way_m);

	DrawnMap m_world, m_known;
	MissionConfig m_config;
	RobotConfig m_robot;
	FrontierMemory m_memory;
	Mission m_mission;
	Eigen::Vector3d m_start, m_at;
	double m_yaw_rad = 0, m_t_s = 1000, m_path_m = 0, m_clearance_m = 10;
	std::vector<Eigen::Vector3d> m_goals;
	int m_flips = 0;
};
}  // namespace explore::test
