// A simulated robot that is driven by what its own camera sees: frames come out, commands go in.
#pragma once

#include <explore/simulation/recorder.h>

namespace explore::simulation
{
struct ClosedLoopConfig
{
	RecorderConfig recorder;  ///< of its fields all but `seconds`
	SimulatedRobotConfig simulated_robot;
	mrpt::poses::CPose3D map_from_start;
	bool exact_pose = true;         ///< frames carry the true pose, else the robot's own estimate
	double command_delay_s = 0.05;  ///< from a frame to the command that answers it
};

/** The same commands give the same frames. Until the first command the robot stands still. */
class ClosedLoop
{
public:
	/** `scene` outlives it. Throws ConfigError where the robot does not fit at its start, or for a delay that is not
	 *  less than the time between two frames. */
	ClosedLoop(RayScene& scene, ClosedLoopConfig config);

	/** Lets the robot go on to the time of the next frame (the first one is taken at the start), and takes that frame.
	 *  What the IMU reads on the way goes to `imu`, where there is one. */
	DepthFrame next(const ObservationSink& imu = {});
	/** What the robot does from command_delay_s after the last frame on, until another command takes effect. */
	void obey(const Command& command);

	[[nodiscard]] const SimulatedRobot& robot() const { return m_robot; }
	/** The least distance [m] so far of the moving robot's body from anything; no value before it moved. Looked at at
	 *  each reading of the IMU. 1 m stands for all that is farther. */
	[[nodiscard]] std::optional<double> minClearance() const { return m_min_clearance_m; }

	/** Writes or reads all that a loop that was made alike needs to go on from here. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_robot), archive(m_frames), archive(m_command), archive(m_next_command);
		archive(m_next_command_at_s), archive(m_min_clearance_m);
	}

private:
	void goOnTo(double t_s, const ObservationSink& imu);
	void watchClearance(const Eigen::Vector3d& before);

	RayScene& m_scene;
	ClosedLoopConfig m_config;
	SimulatedRobot m_robot;
	std::size_t m_frames = 0;
	Command m_command, m_next_command;
	double m_next_command_at_s = 0;
	std::optional<double> m_min_clearance_m;
};
}  // namespace explore::simulation
