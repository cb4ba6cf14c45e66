#include <explore/core/errors.h>
#include <explore/sinks/robot_link/robot2nav_sink.h>
#include <explore/sinks/robot_link/robot_link.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/kinematics/CVehicleVelCmd_Holo.h>
#include <mrpt/nav/reactive/CRobot2NavInterface.h>

using namespace explore;
using mrpt::kinematics::CVehicleVelCmd;
using mrpt::kinematics::CVehicleVelCmd_DiffDriven;
using mrpt::kinematics::CVehicleVelCmd_Holo;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

namespace
{
/** A robot as somebody wraps one for MRPT's navigators; `Kind` is the command it takes. */
template <class Kind>
class FakeRobot : public mrpt::nav::CRobot2NavInterface
{
public:
	bool getCurrentPoseAndSpeeds(mrpt::math::TPose2D&, mrpt::math::TTwist2D&, mrpt::system::TTimeStamp&,
	                             mrpt::math::TPose2D&, std::string&) override
	{
		return false;
	}
	bool changeSpeeds(const CVehicleVelCmd& command) override
	{
		const auto& taken = dynamic_cast<const Kind&>(command);
		std::vector<double> values;
		for (std::size_t i = 0; i < taken.getVelCmdLength(); ++i)
			values.push_back(taken.getVelCmdElement(static_cast<int>(i)));
		commands.push_back(values);
		return takes_commands;
	}
	bool stop(bool) override
	{
		++stops;
		return takes_commands;
	}
	CVehicleVelCmd::Ptr getEmergencyStopCmd() override { return getStopCmd(); }
	CVehicleVelCmd::Ptr getStopCmd() override { return std::make_shared<Kind>(); }
	bool senseObstacles(mrpt::maps::CSimplePointsMap&, mrpt::system::TTimeStamp&) override { return false; }
	bool startWatchdog(float period_ms) override
	{
		watchdog_ms = period_ms;
		return true;
	}
	bool stopWatchdog() override
	{
		watchdog_ms = 0;
		return true;
	}

	std::vector<std::vector<double>> commands;  ///< the elements of each
	int stops = 0;
	float watchdog_ms = 0;
	bool takes_commands = true;
};

/** Takes steering angles, not velocities. */
class Steered : public CVehicleVelCmd_DiffDriven
{
};
class SteeredRobot : public FakeRobot<Steered>
{
public:
	CVehicleVelCmd::Ptr getStopCmd() override { return nullptr; }
};

TimedCommand moving(const Eigen::Vector3d& velocity_mps, double yaw_rate_radps)
{
	TimedCommand command;
	command.command = {velocity_mps, yaw_rate_radps};
	return command;
}
}  // namespace

TEST(Robot2NavSink, DrivesADifferentialRobot)
{
	FakeRobot<CVehicleVelCmd_DiffDriven> robot;
	LinkRemarks remarks;
	{
		Robot2NavSink sink(robot, 0.25, remarks);
		EXPECT_EQ(robot.watchdog_ms, 250.0F);
		sink.send(moving({0.4, 0.0, 0.0}, -0.3));
		EXPECT_EQ(robot.stops, 0);
		sink.stop(1.0);
		EXPECT_EQ(robot.stops, 1);
	}
	EXPECT_THAT(robot.commands, ElementsAre(ElementsAre(0.4, -0.3)));
	EXPECT_EQ(robot.stops, 2) << "it is left standing";
	EXPECT_EQ(robot.watchdog_ms, 0.0F);
	EXPECT_THAT(remarks.take(), IsEmpty());
}

TEST(Robot2NavSink, DrivesAHolonomicRobot)
{
	FakeRobot<CVehicleVelCmd_Holo> robot;
	LinkRemarks remarks;
	Robot2NavSink sink(robot, 0.2, remarks);
	sink.send(moving({0.0, 0.3, 0.1}, 0.2));
	EXPECT_THAT(robot.commands,
	            ElementsAre(ElementsAre(DoubleNear(0.3, 1e-12), DoubleNear(1.5707963267948966, 1e-12), 0.0, 0.2)));
	EXPECT_THAT(remarks.take(), ElementsAre(HasSubstr("no vertical speed")));
}

TEST(Robot2NavSink, ARobotThatFailsIsAnError)
{
	FakeRobot<CVehicleVelCmd_DiffDriven> robot;
	LinkRemarks remarks;
	Robot2NavSink sink(robot, 0.2, remarks);
	robot.takes_commands = false;
	EXPECT_THAT(
	    [&] {
		    sink.send(moving({0.1, 0.0, 0.0}, 0.0));
	    },
	    ThrowsMessage<OutputError>(HasSubstr("changeSpeeds")));
	EXPECT_THAT([&] { sink.stop({}); }, ThrowsMessage<OutputError>(HasSubstr("stop()")));
}

TEST(Robot2NavSink, ARobotOfAnotherKindIsRefused)
{
	SteeredRobot robot;
	LinkRemarks remarks;
	EXPECT_THAT([&] { Robot2NavSink(robot, 0.2, remarks); }, ThrowsMessage<ConfigError>(HasSubstr("getStopCmd()")));
}

TEST(Robot2NavSink, IsDrivenByTheLink)
{
	FakeRobot<CVehicleVelCmd_DiffDriven> robot;
	LinkRemarks remarks;
	{
		RobotLink link(std::make_unique<Robot2NavSink>(robot, 5.0, remarks), {100.0, 5.0}, remarks);
		Decision decision;
		decision.command.velocity_mps.x() = 0.2;
		link.decided(decision, 1.0);
		std::this_thread::sleep_for(std::chrono::milliseconds(300));
	}
	EXPECT_GT(robot.commands.size(), 2U);
	EXPECT_GE(robot.stops, 6);
}
