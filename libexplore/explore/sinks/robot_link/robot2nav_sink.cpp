#include <explore/core/errors.h>
#include <explore/sinks/robot_link/robot2nav_sink.h>
#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/kinematics/CVehicleVelCmd_Holo.h>
#include <mrpt/nav/reactive/CRobot2NavInterface.h>

#include <cmath>

namespace explore
{
namespace
{
using mrpt::kinematics::CVehicleVelCmd_DiffDriven;
using mrpt::kinematics::CVehicleVelCmd_Holo;

bool takesHolonomicCommands(mrpt::nav::CRobot2NavInterface& robot)
{
	const auto example = robot.getStopCmd();
	if (dynamic_cast<const CVehicleVelCmd_Holo*>(example.get()) != nullptr) return true;
	if (dynamic_cast<const CVehicleVelCmd_DiffDriven*>(example.get()) != nullptr) return false;
	throw ConfigError(
	    "the robot's getStopCmd() is neither a CVehicleVelCmd_Holo nor a CVehicleVelCmd_DiffDriven: it cannot be "
	    "driven by velocities");
}

// MRPT's commands cannot be copied, their base's copy constructor calling what is not there yet: they are made where
// they are used.

bool drive(mrpt::nav::CRobot2NavInterface& robot, const Command& command)
{
	CVehicleVelCmd_DiffDriven order;
	order.lin_vel = command.velocity_mps.x();
	order.ang_vel = command.yaw_rate_radps;
	return robot.changeSpeeds(order);
}

bool driveHolonomic(mrpt::nav::CRobot2NavInterface& robot, const Command& command)
{
	CVehicleVelCmd_Holo order;
	order.vel = command.velocity_mps.head<2>().norm();
	order.dir_local = std::atan2(command.velocity_mps.y(), command.velocity_mps.x());
	order.ramp_time = 0.0;  // at once: the speeds change gently already
	order.rot_speed = command.yaw_rate_radps;
	return robot.changeSpeeds(order);
}
}  // namespace

Robot2NavSink::Robot2NavSink(mrpt::nav::CRobot2NavInterface& robot, double watchdog_s, LinkRemarks& remarks)
    : m_robot(robot), m_remarks(remarks), m_holonomic(takesHolonomicCommands(robot))
{
	constexpr double kMillisecondsPerSecond = 1000.0;
	m_robot.startWatchdog(static_cast<float>(watchdog_s * kMillisecondsPerSecond));
}

Robot2NavSink::~Robot2NavSink()
{
	try
	{
		m_robot.stop(false);
		m_robot.stopWatchdog();
	}
	catch (const std::exception& error)
	{
		m_remarks.say("robot fails at the end", std::string("robot: ") + error.what());
	}
}

void Robot2NavSink::send(const TimedCommand& command)
{
	if (command.command.velocity_mps.z() != 0.0)
		m_remarks.say("vertical speed", "robot: MRPT's velocity commands have no vertical speed: climbs are left out");
	const bool taken = m_holonomic ? driveHolonomic(m_robot, command.command) : drive(m_robot, command.command);
	if (!taken) throw OutputError("the robot does not take velocity commands: changeSpeeds() failed");
}

void Robot2NavSink::stop(std::optional<double> /*t_s*/)
{
	if (!m_robot.stop(false)) throw OutputError("the robot does not take velocity commands: stop() failed");
}
}  // namespace explore
