// A robot in a simulated world: takes commands, moves, bumps into things, and senses its own motion.
#pragma once

#include <explore/core/contact.h>
#include <explore/simulation/movers.h>
#include <explore/simulation/odometry.h>
#include <explore/simulation/ray_scene.h>

#include <cstdint>
#include <vector>

namespace explore::simulation
{
/** The same commands and seed give the same motion, estimates and readings. */
class SimulatedRobot
{
public:
	/** Stands still at `map_from_start`, which for a ground robot is level. `scene` outlives it; its moving bodies are
	 *  placed by advance(). Throws ConfigError where the body would touch something there. */
	SimulatedRobot(RayScene& scene, const RobotConfig& robot, const SimulatedRobotConfig& config,
	               const mrpt::poses::CPose3D& map_from_start, std::uint64_t seed);

	/** Follows `command` for `dt_s` > 0 as the limits allow (see robot_motion.h); people and things move meanwhile.
	 * What is in the way stops the robot on the spot: it never passes through. */
	void advance(const Command& command, double dt_s);

	[[nodiscard]] const RobotState& trueState() const { return m_state; }
	/** map_from_robot as the robot's odometry or state estimate has it; at the start it is the true one. */
	[[nodiscard]] mrpt::poses::CPose3D estimate() const { return m_odometry.estimate(); }
	/** The mean over the last advance(). */
	[[nodiscard]] const ImuReading& imu() const { return m_imu_reading; }
	/** Touches so far. One that lasts counts once, until the robot was 2 cm away from where it began. */
	[[nodiscard]] const std::vector<Contact>& contacts() const { return m_contacts; }
	[[nodiscard]] const RobotConfig& config() const { return m_limits.robot; }

	/** Whether the robot's body would touch anything now if it were there. */
	[[nodiscard]] bool touchesAt(const Eigen::Vector3d& position_in_map) const;

	/** Writes or reads what advance() changes, for a robot in the same world that was made alike. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_state), archive(m_movers), archive(m_odometry), archive(m_imu), archive(m_imu_reading);
		archive(m_contacts), archive(m_in_contact);
		if (Archive::kReads && !m_movers.empty()) m_scene->place(m_movers.placement());
	}

private:
	void step(const Command& command, double dt_s);
	void moveMovers(double dt_s);
	void stopAtContact(const RobotState& target);

	RayScene* m_scene;
	MotionLimits m_limits;
	BodyShape m_shape;
	RobotState m_state;
	Movers m_movers;
	Odometry m_odometry;
	Imu m_imu;
	ImuReading m_imu_reading;
	std::vector<Contact> m_contacts;
	bool m_in_contact = false;
};
}  // namespace explore::simulation
