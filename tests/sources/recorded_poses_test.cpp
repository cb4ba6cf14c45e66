// The pose of the robot at a frame's time, from every kind of recorded pose.
#include <explore/core/geometry.h>
#include <explore/sources/pose_track.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <cmath>
#include <limits>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;

/** A robot on a circle of 2 m radius about (0, 2): closed form at any time. */
CPose3D onCircle(double seconds)
{
	const double turn_rad = 0.4 * seconds;
	return {2.0 * std::sin(turn_rad), 2.0 - 2.0 * std::cos(turn_rad), 0, turn_rad, 0, 0};
}

Objects::value_type odometry(double seconds, const CPose3D& pose, const std::string& label = "ODO")
{
	auto observation = mrpt::obs::CObservationOdometry::Create();
	observation->timestamp = at(seconds);
	observation->sensorLabel = label;
	observation->odometry = CPose2D(pose);
	return observation;
}

Objects::value_type robotPose(double seconds, const CPose3D& pose, const CPose3D& robot_from_sensor = {})
{
	auto observation = mrpt::obs::CObservationRobotPose::Create();
	observation->timestamp = at(seconds);
	observation->sensorLabel = "GPS";
	observation->pose.mean = pose;
	observation->sensorPose = robot_from_sensor;
	return observation;
}

Objects::value_type scanAt(double seconds)
{
	return scanOf(sceneFrame(), seconds);
}

Objects::value_type move2D(const CPose2D& increment)
{
	mrpt::obs::CActionRobotMovement2D movement;
	movement.computeFromOdometry(increment, {});
	auto action = mrpt::obs::CActionCollection::Create();
	action->insert(movement);
	return action;
}

Objects::value_type move3D(const CPose3D& increment)
{
	mrpt::obs::CActionRobotMovement3D movement;
	movement.poseChange.mean = increment;
	auto action = mrpt::obs::CActionCollection::Create();
	action->insert(movement);
	return action;
}

Objects::value_type sensoryFrame(double seconds)
{
	auto sensory_frame = mrpt::obs::CSensoryFrame::Create();
	sensory_frame->insert(scanOf(sceneFrame(), seconds));
	return sensory_frame;
}

std::vector<DepthFrame> framesOf(const Objects& objects, PosePolicy policy = PosePolicy::automatic,
                                 SourceReport* report = nullptr, Listener* listener = nullptr)
{
	const auto log = testFolder() / "poses.rawlog";
	writeRawlog(log, objects, Packing::plain);
	SourceConfig config = configFor(log);
	config.pose = policy;
	return replay(config, report, listener);
}

TEST(Interpolation, FollowsAScrewOfConstantTurnExactlyInRotation)
{
	const CPose3D a(0, 0, 0, 0.2, 0, 0), b(1, -2, 4, 1.4, 0, 0);
	for (const double share : {0.0, 0.25, 0.5, 0.9, 1.0})
		expectSamePose(interpolate(a, b, share), {share, -2 * share, 4 * share, 0.2 + 1.2 * share, 0, 0});
}

TEST(Interpolation, TakesTheShortWayAcrossPi)
{
	const CPose3D a(0, 0, 0, 3.0, 0, 0), b(0, 0, 0, -3.0, 0, 0);
	expectSamePose(interpolate(a, b, 0.5), {0, 0, 0, M_PI, 0, 0});
}

TEST(Interpolation, HalfWayIsAsFarFromBothEnds)
{
	const CPose3D a(1, 2, 3, 0.3, -0.4, 0.5), b(-1, 0, 2, -1.0, 0.7, 2.0);
	const CPose3D middle = interpolate(a, b, 0.5);
	// From a to the middle is the same turn as from the middle to b.
	const Eigen::Matrix3d first = isometryOf(middle - a).linear(), second = isometryOf(b - middle).linear();
	EXPECT_TRUE(first.isApprox(second, 1e-9));
}

TEST(PoseTrack, HoldsTheNearestOutsideAndForgetsWithoutChangingAnswers)
{
	PoseTrack track;
	EXPECT_FALSE(track.at(at(0)));
	for (int i = 10; i >= 0; --i) track.add(at(i), CPose3D(i, 0, 0, 0, 0, 0));
	expectSamePose(*track.at(at(-5)), CPose3D(0, 0, 0, 0, 0, 0));
	expectSamePose(*track.at(at(50)), CPose3D(10, 0, 0, 0, 0, 0));
	EXPECT_TRUE(track.reaches(at(10)));
	EXPECT_FALSE(track.reaches(at(10.01)));
	track.forgetBefore(at(4.5));
	EXPECT_NEAR(track.at(at(4.75))->x(), 4.75, 1e-6);
	track.add(at(7), CPose3D(100, 0, 0, 0, 0, 0));
	EXPECT_NEAR(track.at(at(7))->x(), 100, 1e-9);
}

TEST(Poses, OdometryIsInterpolatedToTheFramesTime)
{
	Objects objects;
	for (int i = 0; i < 40; ++i)
	{
		// A frame between two odometry readings, written before the later one.
		objects.push_back(odometry(0.05 * i, onCircle(0.05 * i)));
		objects.push_back(scanAt(0.05 * i + 0.02));
	}
	SourceReport report;
	const auto frames = framesOf(objects, PosePolicy::automatic, &report);
	ASSERT_EQ(frames.size(), 40U);
	EXPECT_EQ(report.pose_origin, PoseOrigin::odometry);
	for (std::size_t i = 0; i + 1 < frames.size(); ++i)
	{
		EXPECT_EQ(frames[i].pose_origin, PoseOrigin::odometry);
		// The chord of 0.02 rad leaves the circle by less than 0.1 mm.
		const CPose3D truth = onCircle(0.05 * static_cast<double>(i) + 0.02);
		EXPECT_NEAR(frames[i].map_from_robot.x(), truth.x(), 1e-4);
		EXPECT_NEAR(frames[i].map_from_robot.y(), truth.y(), 1e-4);
		EXPECT_NEAR(frames[i].map_from_robot.yaw(), truth.yaw(), 1e-6);
	}
	expectSamePose(frames.back().map_from_robot, onCircle(0.05 * 39), 1e-6);
}

TEST(Poses, ARobotPoseSensorMountedOnTheRobotTellsWhereTheRobotIs)
{
	const CPose3D truth(3, 1, 0.2, 0.5, 0.1, -0.1), mount(0.3, -0.2, 0.8, 1.2, 0, 0.4);
	const auto frames = framesOf({scanAt(0), robotPose(0, truth + mount, mount)});
	expectSamePose(frames.at(0).map_from_robot, truth);
	EXPECT_EQ(frames.at(0).pose_origin, PoseOrigin::robot_pose);
}

TEST(Poses, TheBestKindOfTheFirstSecondsIsTaken)
{
	// The better kind appears only after the first frames and the odometry that would do for them.
	const Objects objects = {odometry(0, {}), scanAt(0.01),       odometry(0.02, {}),
	                         scanAt(0.03),    odometry(0.04, {}), robotPose(0.05, CPose3D(9, 0, 0, 0, 0, 0))};
	for (const auto& frame : framesOf(objects)) EXPECT_EQ(frame.pose_origin, PoseOrigin::robot_pose);
	for (const auto& frame : framesOf(objects, PosePolicy::odometry))
		EXPECT_EQ(frame.pose_origin, PoseOrigin::odometry);
	for (const auto& frame : framesOf(objects, PosePolicy::none))
	{
		EXPECT_EQ(frame.pose_origin, PoseOrigin::none);
		expectSamePose(frame.map_from_robot, {});
	}
}

TEST(Poses, AnAskedKindThatIsMissingIsSaidOnceAndLeavesTheIdentity)
{
	Listener listener;
	const auto frames = framesOf({odometry(0, onCircle(1)), scanAt(0), scanAt(0.1), scanAt(0.2)}, PosePolicy::action,
	                             nullptr, &listener);
	ASSERT_EQ(frames.size(), 3U);
	expectSamePose(frames[2].map_from_robot, {});
	EXPECT_EQ(listener.warnings("(action)"), 1U);
}

TEST(Poses, MovementsAddUpAndBelongToTheSensoryFrameThatFollows)
{
	Objects objects;
	const CPose2D step_2d(0.2, 0.01, 0.1);
	for (int i = 0; i < 5; ++i)
	{
		objects.push_back(move2D(step_2d));
		objects.push_back(sensoryFrame(0.1 * i));
	}
	const auto frames = framesOf(objects);
	ASSERT_EQ(frames.size(), 5U);
	Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();
	for (const DepthFrame& frame : frames)
	{
		truth = truth * Eigen::Translation3d(0.2, 0.01, 0) * Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ());
		EXPECT_TRUE(isometryOf(frame.map_from_robot).isApprox(truth, 1e-9));
		EXPECT_EQ(frame.pose_origin, PoseOrigin::action);
	}
}

TEST(Poses, MovementsIn3D)
{
	const CPose3D step_3d(0.1, 0, 0.05, 0.1, 0.2, 0.3);
	const auto frames = framesOf({sensoryFrame(0), move3D(step_3d), sensoryFrame(1), move3D(step_3d), sensoryFrame(2)});
	ASSERT_EQ(frames.size(), 3U);
	expectSamePose(frames[0].map_from_robot, {});
	expectSamePose(frames[1].map_from_robot, step_3d);
	expectSamePose(frames[2].map_from_robot, step_3d + step_3d);
}

TEST(Poses, OfTwoOdometersTheFirstCounts)
{
	Listener listener;
	const auto frames = framesOf({odometry(0, onCircle(1), "A"), odometry(0, onCircle(2), "B"), scanAt(0)},
	                             PosePolicy::automatic, nullptr, &listener);
	expectSamePose(frames.at(0).map_from_robot, onCircle(1), 1e-6);
	EXPECT_EQ(listener.warnings("'B' is not"), 1U);
}

TEST(Poses, ThatAreNotFiniteAreLeftOut)
{
	const double nan = std::numeric_limits<double>::quiet_NaN();
	CPose3D bad;
	bad.x(nan);
	Listener listener;
	const auto frames =
	    framesOf({robotPose(0, onCircle(0)), robotPose(0.5, bad), robotPose(1, onCircle(1)), scanAt(0.999)},
	             PosePolicy::automatic, nullptr, &listener);
	EXPECT_NEAR(frames.at(0).map_from_robot.yaw(), 0.4 * 0.999, 1e-6);
	EXPECT_EQ(listener.warnings("not finite"), 1U);
}

TEST(Poses, ThatBeginLateAreNotUsedHalfWay)
{
	Objects objects;
	for (int i = 0; i < 40; ++i) objects.push_back(scanAt(0.1 * i));
	objects.push_back(odometry(4, onCircle(4)));
	objects.push_back(scanAt(4.1));
	Listener listener;
	for (const auto& frame : framesOf(objects, PosePolicy::automatic, nullptr, &listener))
		EXPECT_EQ(frame.pose_origin, PoseOrigin::none);
	EXPECT_EQ(listener.warnings("begin only after"), 1U);
}

}  // namespace
}  // namespace explore::test
