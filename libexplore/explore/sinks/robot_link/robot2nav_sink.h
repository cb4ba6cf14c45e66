// Drives any robot that is wrapped for MRPT's navigators (mrpt::nav::CRobot2NavInterface).
#pragma once

#include <explore/sinks/robot_link/command_sink.h>
#include <explore/sinks/robot_link/link_remarks.h>

namespace mrpt::nav
{
class CRobot2NavInterface;
}

namespace explore
{
/** Commands become the kind of velocity command that the robot's own getStopCmd() is of: CVehicleVelCmd_DiffDriven
 * takes the forward speed and the yaw rate, CVehicleVelCmd_Holo speed, direction and yaw rate (its direction does not
 * turn with the robot while the command lasts, so that it is to be sent often). Neither knows a vertical speed: what a
 * MAV climbs is left out, which is remarked once. */
class Robot2NavSink : public CommandSink
{
public:
	/** Starts the robot's watchdog with `watchdog_s`. `robot` and `remarks` outlive the sink. Throws ConfigError where
	 *  the robot takes neither kind of command. */
	Robot2NavSink(mrpt::nav::CRobot2NavInterface& robot, double watchdog_s, LinkRemarks& remarks);
	/** Stops the robot and its watchdog. */
	~Robot2NavSink() override;

	/** Throws OutputError where the robot does not take the command. */
	void send(const TimedCommand& command) override;
	/** Throws OutputError where the robot refuses to stop. */
	void stop(std::optional<double> t_s) override;

private:
	mrpt::nav::CRobot2NavInterface& m_robot;
	LinkRemarks& m_remarks;
	bool m_holonomic = false;
};
}  // namespace explore
