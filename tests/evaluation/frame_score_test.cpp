#include "evaluation/truth_maker.h"

#include <explore/evaluation/frame_score.h>
#include <gmock/gmock.h>

#include <numbers>

using namespace explore;
using namespace explore::evaluation;

namespace
{
/** A robot at the map's origin that looks along x; each test fills in what is there and what it reports. */
struct Frame
{
	std::string log = "a.rawlog";
	DepthFrame frame;
	StepResult result;
	TruthLog truth;
	TruthFrame truth_frame;
	ExplorerConfig config;

	Frame()
	{
		truth.intrinsics = {640, 480, 588.0, 588.0, 319.5, 239.5};
		truth.robot_from_camera = mrpt::poses::CPose3D(0.1, 0, 1.0, 0, 0, 0);
		truth_frame.corridor.state = CorridorState::not_scored;
	}
	Door& report(double x_m, double y_m, double width_m, Verdict verdict = Verdict::open)
	{
		Door door;
		door.center = {x_m, y_m, 1.0};
		door.normal = -Eigen::Vector3d::UnitX();
		door.width_m = door.clear_width_m = width_m;
		door.verdict = verdict;
		result.percepts.doors.push_back(door);
		return result.percepts.doors.back();
	}
	TruthDoor& closedTo(TruthDoor door, Verdict verdict)
	{
		door.verdict = verdict;
		door.passable = false;
		truth_frame.doors.push_back(door);
		return truth_frame.doors.back();
	}
	[[nodiscard]] ScoreInput input() const { return {log, frame, result, truth, truth_frame, config}; }
	[[nodiscard]] FrameScore score() const { return scoreFrame(input()); }
};
}  // namespace

TEST(FrameScore, CentreErrorsAreSplitAlongTheTrueWall)
{
	Frame f;
	TruthDoor door = test::openDoor("a", 2.0, 1.0, 0.9);
	door.normal_in_map = {-std::cos(0.5), -std::sin(0.5), 0.0};  // the wall is turned
	f.truth_frame.doors = {door};
	// 6 cm toward the camera, 4 cm to the left as one stands before the wall.
	const Eigen::Vector2d normal = door.normal_in_map.head<2>(), left(normal.y(), -normal.x());
	EXPECT_GT(left.y(), 0.0) << "left of a robot that looks along x is y";
	const Eigen::Vector2d center = door.center_in_map.head<2>() + 0.06 * normal + 0.04 * left;
	f.report(center.x(), center.y(), 0.9);
	const Tally tally = f.score().tally;
	ASSERT_EQ(tally.width_errors_m.size(), 1U);
	EXPECT_NEAR(tally.across_errors_m[0], 0.06, 1e-4);
	EXPECT_NEAR(tally.along_errors_m[0], 0.04, 1e-4);
	EXPECT_NEAR(tally.center_errors_m[0], std::hypot(0.06, 0.04), 1e-4);
	EXPECT_NEAR(tally.hit_distances_m[0], std::hypot(1.9, 1.0), 1e-4) << "from the camera";
	EXPECT_THAT(doorRows(f.input(), f.score())[0], testing::EndsWith(",0.0721,0,0.04,0.06\n"));
}

TEST(FrameScore, NarrowDoorsAreCountedByTheirTrueWidth)
{
	Frame f;
	f.truth_frame.doors = {test::openDoor("a", 3, -1, 0.84), test::openDoor("b", 3, 1, 0.83),
	                       test::openDoor("c", 3, 3, 0.86)};
	f.report(3, -1, 0.95);
	const Tally tally = f.score().tally;
	EXPECT_EQ(tally.narrow_hits, 1U);
	EXPECT_EQ(tally.narrow_misses, 1U);
}

TEST(FrameScore, OpenReportsWhereNothingCanBePassed)
{
	Frame f;
	f.closedTo(test::openDoor("a", 2.5, 0, 0.9), Verdict::unknown);
	f.report(2.5, 0, 0.9);
	EXPECT_EQ(f.score().tally.open_reports, 1U);
	EXPECT_EQ(f.score().tally.false_alarm_frames, 1U);
	f.report(2.5, 1.5, 0.3);  // too narrow to be a false alarm, and called open all the same
	EXPECT_EQ(f.score().tally.open_reports, 2U);
	EXPECT_EQ(f.score().tally.open_frames, 1U);
	f.result.percepts.doors[0].verdict = Verdict::passage;
	EXPECT_EQ(f.score().tally.open_reports, 1U);
	EXPECT_EQ(f.score().tally.false_alarm_frames, 1U);
	f.truth_frame.doors = {test::openDoor("a", 2.5, 0, 0.9), test::openDoor("b", 2.5, 1.5, 0.4)};
	EXPECT_EQ(f.score().tally.open_reports, 0U) << "there are doors now";
}

TEST(FrameScore, StairsCountUpToThreeMetres)
{
	Frame f;
	f.closedTo(test::openDoor("stairs", 3.2, 0, 0.9), Verdict::drop);
	f.report(3.2, 0, 0.9);
	const Tally far = f.score().tally;
	EXPECT_EQ(far.main().false_alarms, 0U);
	EXPECT_EQ(far.open_reports, 0U);
	EXPECT_EQ(far.unscored_frames, 1U);
	f.truth_frame.doors[0].center_in_map.x() = f.result.percepts.doors[0].center.x() = 3.0;  // 2.9 m from the camera
	const Tally near = f.score().tally;
	EXPECT_EQ(near.main().false_alarms, 1U);
	EXPECT_EQ(near.open_reports, 1U);
	EXPECT_EQ(near.false_alarm_frames, 1U);
	EXPECT_EQ(near.unscored_frames, 0U);
	// What is no drop has no such limit.
	f.truth_frame.doors[0].center_in_map.x() = f.result.percepts.doors[0].center.x() = 3.2;
	f.truth_frame.doors[0].verdict = Verdict::closed;
	EXPECT_EQ(f.score().tally.main().false_alarms, 1U);
}

TEST(FrameScore, DirectionsWithinTwoDegrees)
{
	Frame f;
	f.truth_frame.corridor = {CorridorState::corridor, Eigen::Vector3d::UnitX(), 2.0};
	for (const double degrees : {0.0, 1.99, -1.99, 2.01, 45.0})
	{
		const double angle = degrees * std::numbers::pi / 180.0;
		VanishingPoint point;
		point.direction = {std::cos(angle), std::sin(angle), 0.0};
		f.result.percepts.vanishing_points = {point};
		EXPECT_EQ(f.score().tally.corridor_given, 1U);
		EXPECT_EQ(f.score().tally.corridor_close, std::abs(degrees) < 2.0 ? 1U : 0U) << degrees;
	}
}
