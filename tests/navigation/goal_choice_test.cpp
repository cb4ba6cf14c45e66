#include <explore/navigation/goal_choice.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace explore
{
namespace
{
Door doorAt(double x, double y, double clear_width_m = 0.9, Verdict verdict = Verdict::open)
{
	Door door;
	door.center = {x, y, 1.0};
	door.width_m = 0.9;
	door.clear_width_m = clear_width_m;
	door.verdict = verdict;
	return door;
}

VanishingPoint vanishingAt(double x, double y, std::size_t inliers)
{
	VanishingPoint point;
	point.point = {x, y, 0.5};
	point.inliers = inliers;
	return point;
}

TEST(GoalChoice, NearestDoorComesBeforeTheVanishingPoint)
{
	Percepts percepts;
	percepts.doors = {doorAt(3.0, 2.0), doorAt(2.0, -1.0), doorAt(4.0, 0.0)};
	percepts.doors[1].track = 7;
	percepts.vanishing_points = {vanishingAt(5.0, 0.5, 100)};
	const GoalChoice choice = chooseGoal(percepts, RobotConfig());
	ASSERT_TRUE(choice.door_rad);
	EXPECT_DOUBLE_EQ(*choice.door_rad, std::atan2(-1.0, 2.0));
	EXPECT_EQ(choice.desired_rad, *choice.door_rad);
	EXPECT_EQ(choice.goal.kind, GoalKind::door);
	EXPECT_EQ(choice.goal.track, 7);
	EXPECT_EQ(choice.goal.point_in_robot, Eigen::Vector3d(2.0, -1.0, 1.0));
	ASSERT_TRUE(choice.vanishing_point_rad) << "reported beside the door";
	EXPECT_DOUBLE_EQ(*choice.vanishing_point_rad, std::atan2(0.5, 5.0));
}

TEST(GoalChoice, VanishingPointWithMostInliersWithoutADoor)
{
	Percepts percepts;
	percepts.vanishing_points = {vanishingAt(5.0, 2.0, 100), vanishingAt(4.0, -1.0, 300), vanishingAt(3.0, 0.0, 200)};
	const GoalChoice choice = chooseGoal(percepts, RobotConfig());
	EXPECT_FALSE(choice.door_rad);
	EXPECT_DOUBLE_EQ(choice.desired_rad, std::atan2(-1.0, 4.0));
	EXPECT_EQ(choice.goal.kind, GoalKind::corridor);
	EXPECT_EQ(choice.goal.point_in_robot, Eigen::Vector3d(4.0, -1.0, 0.5));
}

TEST(GoalChoice, StraightOnWhenThereIsNothing)
{
	const GoalChoice choice = chooseGoal(Percepts(), RobotConfig());
	EXPECT_FALSE(choice.door_rad);
	EXPECT_FALSE(choice.vanishing_point_rad);
	EXPECT_EQ(choice.desired_rad, 0.0);
	EXPECT_EQ(choice.goal.kind, GoalKind::none);
	EXPECT_FALSE(choice.goal.point_in_robot);
}

TEST(GoalChoice, OnlyDoorsThatCanBePassedNowCount)
{
	for (const auto& [verdict, counts] :
	     {std::pair{Verdict::open, true}, std::pair{Verdict::ajar, true}, std::pair{Verdict::passage, true},
	      std::pair{Verdict::closed, false}, std::pair{Verdict::blocked, false}, std::pair{Verdict::drop, false},
	      std::pair{Verdict::partial, false}, std::pair{Verdict::unknown, false}})
	{
		Percepts percepts;
		percepts.doors = {doorAt(2.0, 1.0, 0.9, verdict)};
		EXPECT_EQ(chooseGoal(percepts, RobotConfig()).door_rad.has_value(), counts) << nameOf(verdict);
	}
}

TEST(GoalChoice, TooNarrowOrTooLowIsNoDoorForThisRobot)
{
	Percepts percepts;
	percepts.doors = {doorAt(2.0, 1.0, 0.53), doorAt(4.0, 1.0, 0.55)};  // the robot needs 0.44 + 0.10 m
	GoalChoice choice = chooseGoal(percepts, RobotConfig());
	ASSERT_TRUE(choice.door_rad);
	EXPECT_DOUBLE_EQ(*choice.door_rad, std::atan2(1.0, 4.0));

	percepts.doors[1].height_m = 0.55;
	EXPECT_FALSE(chooseGoal(percepts, RobotConfig()).door_rad);
	percepts.doors[1].height_m = 2.0;
	EXPECT_TRUE(chooseGoal(percepts, RobotConfig()).door_rad);
}

TEST(GoalChoice, AzimuthIsAboutTheFloorsNormal)
{
	// A camera that looks 0.25 rad down and is itself the robot frame; the door stands level, 2 m ahead and 1 m left.
	const Eigen::Matrix3d robot_from_level =
	    Eigen::AngleAxisd(0.25, Eigen::Vector3d::UnitY()).toRotationMatrix().transpose();
	Percepts percepts;
	percepts.ground = Ground{};
	percepts.ground->plane = {robot_from_level * Eigen::Vector3d::UnitZ(), 0.5};
	percepts.doors = {doorAt(0.0, 0.0)};
	percepts.doors[0].center = robot_from_level * Eigen::Vector3d(2.0, 1.0, 0.5);
	const GoalChoice choice = chooseGoal(percepts, RobotConfig());
	ASSERT_TRUE(choice.door_rad);
	EXPECT_NEAR(*choice.door_rad, std::atan2(1.0, 2.0), 1e-12);
}
}  // namespace
}  // namespace explore
