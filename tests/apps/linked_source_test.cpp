#include "support/analytic_scene.h"

#include <common/linked_source.h>
#include <gmock/gmock.h>
#include <mrpt/system/COutputLogger.h>

#include <cmath>
#include <numbers>

using namespace explore;
using namespace explore::app;
using testing::HasSubstr;
using testing::SizeIs;

namespace
{
constexpr double kStart_s = 1.6e9;

/** Frames without content at 10 Hz, placed by odometry. */
class BareSource : public FrameSource
{
public:
	std::optional<DepthFrame> next() override
	{
		DepthFrame frame;
		frame.index = m_delivered;
		frame.timestamp = mrpt::Clock::fromDouble(kStart_s + 0.1 * static_cast<double>(m_delivered));
		frame.map_from_robot = mrpt::poses::CPose3D(7, 7, 0, 0, 0, 0);
		frame.pose_origin = PoseOrigin::odometry;
		++m_delivered;
		return frame;
	}
	[[nodiscard]] SourceReport report() const override { return {}; }
	[[nodiscard]] std::optional<double> progress() const override { return std::nullopt; }

private:
	std::size_t m_delivered = 0;
};

struct Linked : testing::Test
{
	Linked()
	{
		logger.logging_enable_console_output = false;
		logger.logRegisterCallback([this](std::string_view message, mrpt::system::VerbosityLevel, std::string_view,
		                                  mrpt::Clock::time_point) { said.emplace_back(message); });
	}
	void tell(const std::string& message) { inbox.take(message, mrpt::Clock::fromDouble(kStart_s)); }
	void tellPose(double after_s, double x)
	{
		tell(R"({"pose":{"t":)" + std::to_string(kStart_s + after_s) + R"(,"y":1,"yaw":0,"x":)" + std::to_string(x) +
		     "}}");
	}
	DepthFrame next() { return source.next().value(); }

	std::vector<std::string> said;
	mrpt::system::COutputLogger logger;
	LinkRemarks remarks;
	RobotInbox inbox{remarks};
	LinkedSource source{std::make_unique<BareSource>(), inbox, logger};
};
}  // namespace

TEST_F(Linked, ASilentRobotChangesNothing)
{
	const DepthFrame frame = next();
	EXPECT_EQ(frame.pose_origin, PoseOrigin::odometry);
	EXPECT_EQ(frame.map_from_robot.x(), 7.0);
	EXPECT_EQ(frame.halt, RobotHalt::none);
	EXPECT_TRUE(frame.more_obstacles_in_robot.empty());
	EXPECT_FALSE(frame.up_in_robot);
	EXPECT_THAT(said, SizeIs(0));
}

TEST_F(Linked, PosesAreInterpolatedToTheFrame)
{
	tellPose(-0.05, 1.0);
	tellPose(0.05, 3.0);
	const DepthFrame frame = next();
	EXPECT_EQ(frame.pose_origin, PoseOrigin::robot_link);
	EXPECT_NEAR(frame.map_from_robot.x(), 2.0, 1e-4);
	EXPECT_EQ(frame.map_from_robot.y(), 1.0);
	EXPECT_EQ(source.report().pose_origin, PoseOrigin::robot_link);
}

TEST_F(Linked, ThePoseJustBeforeIsTakenAndAnOldOneHalts)
{
	tellPose(0.0, 1.0);
	EXPECT_EQ(next().map_from_robot.x(), 1.0);
	for (int i = 0; i < 2; ++i)  // 0.1 and 0.2 s later
	{
		const DepthFrame frame = next();
		if (i == 0)
		{
			EXPECT_EQ(frame.pose_origin, PoseOrigin::robot_link);
		}
	}
	for (int i = 0; i < 3; ++i)
	{
		const DepthFrame lost = next();
		EXPECT_EQ(lost.halt, RobotHalt::link_lost);
		EXPECT_EQ(lost.pose_origin, PoseOrigin::none) << "never the odometry of another frame";
	}
	ASSERT_THAT(said, SizeIs(1)) << "once";
	EXPECT_THAT(said[0], HasSubstr("no pose within 0.2 s"));
	tellPose(0.6, 2.0);
	const DepthFrame back = next();
	EXPECT_EQ(back.halt, RobotHalt::none);
	EXPECT_EQ(back.map_from_robot.x(), 2.0);
}

TEST_F(Linked, APoseThatComesLateIsRemarked)
{
	next();
	tellPose(0.1, 1.0);
	EXPECT_EQ(next().pose_origin, PoseOrigin::robot_link);
	ASSERT_THAT(said, SizeIs(1));
	EXPECT_THAT(said[0], HasSubstr("from frame 1 on"));
}

TEST_F(Linked, AnotherClockIsRemarkedAndPassedOver)
{
	tellPose(100.0, 1.0);
	EXPECT_EQ(next().pose_origin, PoseOrigin::odometry);
	ASSERT_THAT(said, SizeIs(1));
	EXPECT_THAT(said[0], HasSubstr("100.0"));
}

TEST_F(Linked, AccelerationsTellWhichWayIsUp)
{
	const double tilt_rad = 0.1;
	for (int i = 0; i < 5; ++i)
		tell(R"({"imu":{"t":)" + std::to_string(kStart_s - 0.02 * i) + R"(,"acceleration":[)" +
		     std::to_string(9.81 * std::sin(tilt_rad)) + ",0," + std::to_string(9.81 * std::cos(tilt_rad)) + "]}}");
	const DepthFrame frame = next();
	ASSERT_TRUE(frame.up_in_robot);
	EXPECT_NEAR(frame.up_in_robot->x(), std::sin(tilt_rad), 1e-4);
	EXPECT_NEAR(frame.up_in_robot->z(), std::cos(tilt_rad), 1e-4);
	next(), next(), next();
	EXPECT_FALSE(next().up_in_robot) << "too old";
}

TEST_F(Linked, AlarmsHaltUntilTheyAreReleased)
{
	tell(R"({"cliff":{"seen":true}})");
	EXPECT_EQ(next().halt, RobotHalt::cliff);
	tell(R"({"bumper":{"pressed":true}})");
	EXPECT_EQ(next().halt, RobotHalt::bumper);
	tell(R"({"bumper":{"pressed":false}})");
	EXPECT_EQ(next().halt, RobotHalt::cliff);
	tell(R"({"cliff":{"seen":false}})");
	EXPECT_EQ(next().halt, RobotHalt::none);
}

TEST_F(Linked, ScansBecomeObstaclesAndTheirLossHalts)
{
	// A sensor 0.2 m ahead that looks back: its beams at -90, 0 and 90 degrees.
	tell(R"({"scan":{"aperture":3.14159265,"ranges":[1.0,2.0,null],"max_range":5,"pose":[0.2,0,0.3,3.14159265,0,0]}})");
	const PointCloud points = next().more_obstacles_in_robot;
	ASSERT_EQ(points.size(), 2U);
	EXPECT_NEAR(points[0].x(), 0.2F, 1e-4F);
	EXPECT_NEAR(points[0].y(), 1.0F, 1e-4F);
	EXPECT_NEAR(points[1].x(), -1.8F, 1e-4F);
	EXPECT_NEAR(points[1].y(), 0.0F, 1e-4F);
	EXPECT_NEAR(points[1].z(), 0.3F, 1e-4F);
	next(), next();
	const DepthFrame lost = next();
	EXPECT_TRUE(lost.more_obstacles_in_robot.empty());
	EXPECT_EQ(lost.halt, RobotHalt::link_lost);
}
