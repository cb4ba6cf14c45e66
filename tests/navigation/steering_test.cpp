#include <explore/navigation/steering.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/drawn_map.h"

namespace explore
{
namespace
{
constexpr double kPi = std::numbers::pi;

/** A hall of 4 m × 3 m; all of it is known. 0.2 m a character. */
std::vector<std::string> hallRows()
{
	std::vector<std::string> rows(15, "#" + std::string(18, '.') + "#");
	rows.front() = rows.back() = std::string(20, '#');
	return rows;
}
const test::DrawnMap kHall(hallRows(), 0.2);
const Eigen::Vector3d kStart(1.0, 1.5, 0.0);

MissionNow at(const Eigen::Vector3d& place, double yaw_rad, double t_s = 100.0)
{
	MissionNow now;
	now.map_from_robot.translate(place).rotate(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
	now.t_s = t_s;
	return now;
}

Mission missionAlong(const std::vector<Eigen::Vector3d>& way, double yaw_rad = 0.0)
{
	Mission mission;
	mission.planned_at_s = 99.0;
	mission.goal.emplace();
	mission.goal->kind = GoalKind::frontier;
	mission.goal->stand_in_map = way.back();
	mission.goal->yaw_rad = yaw_rad;
	mission.way_in_map = way;
	return mission;
}

/** One robot that steers through the hall. */
class SteeringInHall : public testing::Test
{
protected:
	SteeringGoal steerAt(const MissionNow& now) { return steer(m_steering, m_mission, m_memory, now, m_robot); }
	/** The robot was stopped because there is no way, or drove, in the frame at t_s. */
	void noWay(double t_s)
	{
		Decision decision;
		decision.stop = true;
		decision.stop_reason = StopReason::no_direction;
		noteDecision(m_steering, decision, false, t_s);
	}
	void drove(double t_s)
	{
		Decision decision;
		decision.command.velocity_mps.x() = 0.3;
		noteDecision(m_steering, decision, false, t_s);
	}

	FrontierMemory m_memory = test::memoryOf(kHall);
	RobotConfig m_robot;
	Steering m_steering;
	Mission m_mission = missionAlong({kStart, {3.0, 1.5, 0.0}});
};

TEST_F(SteeringInHall, WithoutAGoalThereIsNothingToDo)
{
	m_mission.goal.reset();
	const SteeringGoal goal = steerAt(at(kStart, 0.0));
	EXPECT_FALSE(goal.turns || goal.backs_off);
	EXPECT_EQ(goal.desired_rad, 0.0);
}

TEST_F(SteeringInHall, AimsAlongTheWayAndSaysHowFarItIs)
{
	const SteeringGoal goal = steerAt(at(kStart, 0.0));
	EXPECT_NEAR(goal.desired_rad, 0.0, 1e-9);
	EXPECT_NEAR(goal.goal_distance_m, 2.0, 1e-9);
	EXPECT_FALSE(goal.turns || goal.backs_off);
	// 20 cm beside the way it comes back to it.
	EXPECT_NEAR(steerAt(at(kStart + Eigen::Vector3d(0, 0.2, 0), 0.0)).desired_rad, -std::atan2(0.2, 0.5), 1e-9);
	EXPECT_NEAR(steerAt(at(kStart, 0.3)).desired_rad, -0.3, 1e-9) << "in the robot's frame";
}

TEST_F(SteeringInHall, GoesAroundCornersAndNotThroughThem)
{
	m_mission = missionAlong({kStart, {2.0, 1.5, 0.0}, {2.0, 2.5, 0.0}});
	EXPECT_NEAR(steerAt(at(kStart, 0.0)).desired_rad, 0.0, 1e-9) << "the corner is 1 m ahead";
	EXPECT_NEAR(steerAt(at(kStart, 0.0)).goal_distance_m, 2.0, 1e-9) << "along both legs";
	EXPECT_NEAR(steerAt(at({1.8, 1.5, 0.0}, 0.0)).desired_rad, std::atan2(0.3, 0.2), 1e-9) << "half a metre on";
	EXPECT_NEAR(steerAt(at({2.0, 2.2, 0.0}, 0.5 * kPi)).goal_distance_m, 0.3, 1e-9);
}

TEST_F(SteeringInHall, TurnsOnTheSpotWithHysteresis)
{
	EXPECT_FALSE(steerAt(at(kStart, 0.55)).turns) << "small turns are driven";
	const SteeringGoal goal = steerAt(at(kStart, 0.65));
	EXPECT_TRUE(goal.turns);
	EXPECT_NEAR(goal.desired_rad, -0.65, 1e-9);
	EXPECT_TRUE(steerAt(at(kStart, 0.55)).turns) << "goes on once begun";
	EXPECT_TRUE(steerAt(at(kStart, 0.2)).turns);
	EXPECT_FALSE(steerAt(at(kStart, 0.1)).turns);
	EXPECT_FALSE(steerAt(at(kStart, 0.5)).turns) << "and does not begin again at once";
}

TEST_F(SteeringInHall, AtTheGoalItTurnsToWhereItIsToLook)
{
	m_mission.goal->yaw_rad = -2.0;
	const SteeringGoal goal = steerAt(at({3.03, 1.52, 0.0}, 1.0));
	EXPECT_TRUE(goal.turns);
	EXPECT_NEAR(std::remainder(goal.desired_rad - (-3.0), 2 * kPi), 0.0, 1e-9);
}

TEST_F(SteeringInHall, AMavAimsUpAndDown)
{
	m_robot.kind = RobotKind::mav;
	m_robot.height_m = 0.25;
	FrontierMemory memory = test::memoryOf(kHall, m_robot);
	m_mission = missionAlong({{1.0, 1.5, 1.0}, {1.0, 1.5, 1.5}, {3.0, 1.5, 1.5}});
	const auto elevation = [&](double z_m) {
		return steer(m_steering, m_mission, memory, at({1.0, 1.5, z_m}, 0.0), m_robot).desired_elevation_rad;
	};
	EXPECT_GT(elevation(1.0), 1.0);
	EXPECT_GT(elevation(1.3), 0.1);
	m_mission = missionAlong({{1.0, 1.5, 1.0}, {1.0, 1.5, 0.5}, {3.0, 1.5, 0.5}});
	EXPECT_LT(elevation(1.0), -1.0);
}

TEST_F(SteeringInHall, WithoutAWayForAWhileItBacksOffAndThePlanKeepsOffTheSpot)
{
	noWay(100.0);
	EXPECT_FALSE(steerAt(at(kStart, 0.0, 101.0)).backs_off) << "a moment's patience";
	EXPECT_TRUE(m_mission.blocked.empty());
	noWay(101.0);
	const SteeringGoal goal = steerAt(at(kStart, 0.0, 102.1));
	EXPECT_TRUE(goal.backs_off);
	ASSERT_EQ(m_mission.blocked.size(), 1U);
	EXPECT_LT((m_mission.blocked[0].at_in_map - Eigen::Vector3d(1.5, 1.5, 0.0)).norm(), 1e-9) << "half a metre ahead";
	EXPECT_GT(m_mission.blocked[0].until_s, 110.0);
	EXPECT_EQ(m_mission.planned_at_s, 0.0) << "a new plan is due";
	// A quarter of a metre back is enough.
	EXPECT_TRUE(steerAt(at({0.85, 1.5, 0.0}, 0.0, 103.0)).backs_off);
	EXPECT_FALSE(steerAt(at({0.74, 1.5, 0.0}, 0.0, 104.0)).backs_off);
	EXPECT_EQ(m_mission.blocked.size(), 1U);
}

TEST_F(SteeringInHall, BlockedThereAgainItMakesMoreRoomEachTime)
{
	const Eigen::Vector3d there(2.0, 1.5, 0.0);
	double t_s = 100.0;
	for (const double room_m : {0.25, 0.5, 1.0, 1.0})
	{
		noWay(t_s);
		EXPECT_TRUE(steerAt(at(there, 0.0, t_s + 2.1)).backs_off);
		EXPECT_TRUE(steerAt(at({2.01 - room_m, 1.5, 0.0}, 0.0, t_s + 2.2)).backs_off) << room_m;
		EXPECT_FALSE(steerAt(at({1.99 - room_m, 1.5, 0.0}, 0.0, t_s + 2.3)).backs_off) << room_m;
		t_s += 4.0;
	}
	m_mission.blocked.clear();  // as they are after a while
	noWay(t_s);
	EXPECT_TRUE(steerAt(at(there, 0.0, t_s + 2.1)).backs_off);
	EXPECT_FALSE(steerAt(at({1.74, 1.5, 0.0}, 0.0, t_s + 2.2)).backs_off);
}

TEST_F(SteeringInHall, BacksOffOnlyIntoWhatIsKnownToBeFree)
{
	for (const Eigen::Vector3d& near : {Eigen::Vector3d(0.55, 1.5, 0.0), Eigen::Vector3d(1.0, 0.35, 0.0)})
	{
		m_steering = {};
		m_mission.blocked.clear();
		noWay(100.0);
		EXPECT_FALSE(steerAt(at(near, 0.0, 103.0)).backs_off) << near.transpose() << ": a wall behind, or beside";
		EXPECT_EQ(m_mission.blocked.size(), 1U) << "the plan knows all the same";
	}
	std::vector<std::string> rows = hallRows();
	for (std::string& row : rows) row[2] = '?';
	m_memory = test::memoryOf(test::DrawnMap(rows, 0.2));
	m_steering = {};
	noWay(100.0);
	EXPECT_FALSE(steerAt(at(kStart, 0.0, 103.0)).backs_off) << "nobody knows what is behind";
}

TEST_F(SteeringInHall, StopsForOtherReasonsAreNoMissingWay)
{
	Decision stale;
	stale.stop = true;
	stale.stop_reason = StopReason::stale_frame;
	noteDecision(m_steering, stale, false, 100.0);
	EXPECT_FALSE(steerAt(at(kStart, 0.0, 105.0)).backs_off);
	noWay(105.0);
	drove(106.0);
	noWay(107.0);
	EXPECT_FALSE(steerAt(at(kStart, 0.0, 108.5)).backs_off) << "it drove in between";
}

TEST_F(SteeringInHall, ARobotThatSeesNothingBacksOffByWhatItRemembersButNotForEver)
{
	Decision dark;
	dark.stop = true;
	dark.stop_reason = StopReason::empty_frame;
	EXPECT_FALSE(mayMoveBlindly(m_steering, 100.0));
	noteDecision(m_steering, dark, true, 100.0);
	EXPECT_FALSE(mayMoveBlindly(m_steering, 100.1)) << "it stops first";
	noteDecision(m_steering, dark, true, 101.5);
	EXPECT_TRUE(steerAt(at(kStart, 0.0, 104.0)).backs_off) << "it has come too near to something";
	EXPECT_TRUE(mayMoveBlindly(m_steering, 110.0));
	noteDecision(m_steering, dark, true, 110.0);
	EXPECT_FALSE(mayMoveBlindly(m_steering, 120.0)) << "the camera is dark";
	noteDecision(m_steering, {}, false, 121.0);
	noteDecision(m_steering, dark, true, 122.0);
	EXPECT_TRUE(mayMoveBlindly(m_steering, 124.0));
}

TEST_F(SteeringInHall, ARobotThatSeesNothingOnItsWayTurnsBackToWhereItCameFromAndGivesItsGoalUp)
{
	m_mission.trail_in_map = {kStart + Eigen::Vector3d(0, 1.0, 0), kStart + Eigen::Vector3d(0, 0.2, 0), kStart};
	m_mission.goal->patience_s = 60.0;
	Decision dark;
	dark.stop = true;
	dark.stop_reason = StopReason::empty_frame;
	noteDecision(m_steering, dark, true, 100.0);
	EXPECT_FALSE(steerAt(at(kStart, 0.0, 100.1)).turns) << "it stops first";
	const SteeringGoal back = steerAt(at(kStart, 0.0, 101.2));
	EXPECT_TRUE(back.turns);
	EXPECT_NEAR(back.desired_rad, 0.5 * kPi, 1e-9);
	EXPECT_EQ(m_mission.goal->patience_s, 0.0);
	EXPECT_EQ(m_mission.blocked.size(), 1U) << "the spot ahead";
	EXPECT_TRUE(steerAt(at(kStart, 0.5, 101.7)).turns);
	EXPECT_EQ(m_mission.blocked.size(), 1U) << "once";
	EXPECT_NEAR(steerAt(at(kStart, -1.0, 101.8)).desired_rad, 0.5 * kPi + 1.0, 1e-9)
	    << "it does not turn to its goal again, far aside as that may be";
	noteDecision(m_steering, {}, false, 102.0);
	EXPECT_FALSE(steerAt(at(kStart, 0.1, 102.1)).turns) << "it sees again";
}

TEST_F(SteeringInHall, ARobotThatDrivesAndGetsNowhereBacksOffToo)
{
	bool backed_off = false;
	for (int i = 0; i < 40 && !backed_off; ++i)
	{
		const double t_s = 100.0 + 0.1 * i;
		backed_off = steerAt(at(kStart + Eigen::Vector3d(0.001 * i, 0, 0), 0.0, t_s)).backs_off;
		drove(t_s);
	}
	EXPECT_TRUE(backed_off);
	m_steering = {};
	for (int i = 0; i < 40; ++i)
	{
		const double t_s = 200.0 + 0.1 * i;
		ASSERT_FALSE(steerAt(at(kStart + Eigen::Vector3d(0.03 * i, 0, 0), 0.0, t_s)).backs_off) << "it makes headway";
		drove(t_s);
	}
}

TEST(Manoeuvre, TurnsWithinTheRobotsLimitsAndStaysWhereItIs)
{
	SteeringGoal goal;
	goal.turns = true;
	for (const double desired_rad : {-3.0, -0.2, 0.1, 2.0})
	{
		goal.desired_rad = desired_rad;
		const Decision decision = manoeuvre({}, goal, {});
		EXPECT_EQ(decision.command.velocity_mps.norm(), 0.0);
		EXPECT_GT(decision.command.yaw_rate_radps * desired_rad, 0.0) << "the shorter way round";
		EXPECT_LE(std::abs(decision.command.yaw_rate_radps), 1.0);
		EXPECT_EQ(decision.headings.chosen_rad, desired_rad);
		EXPECT_FALSE(decision.stop);
	}
}

TEST(Manoeuvre, BacksOffSlowlyAndSaysThatItRecovers)
{
	SteeringGoal goal;
	goal.backs_off = true;
	GoalChoice choice;
	choice.goal.kind = GoalKind::door;
	const Decision decision = manoeuvre(choice, goal, {});
	EXPECT_LT(decision.command.velocity_mps.x(), 0.0);
	EXPECT_GE(decision.command.velocity_mps.x(), -0.2);
	EXPECT_EQ(decision.command.yaw_rate_radps, 0.0);
	EXPECT_EQ(decision.goal.kind, GoalKind::recover);
	RobotConfig slow;
	slow.max_speed_mps = 0.05;
	EXPECT_EQ(manoeuvre(choice, goal, slow).command.velocity_mps.x(), -0.05);
}
}  // namespace
}  // namespace explore
