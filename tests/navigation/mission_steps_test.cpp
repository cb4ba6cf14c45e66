// What a mission decides when it is told where the robot is and what it knows: goals, their ends, and the end of all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "navigation/mission_run.h"

namespace explore
{
namespace
{
/** A room whose exit, at the right, is closed ('d') or not; 0.2 m a character. */
test::DrawnMap roomWith(char exit)
{
	std::vector<std::string> rows{"????????????????????", "###############?????", "#.............#?????",
	                              "#.............#?????", "#.............#?????", "#.............d?????",
	                              "#..h.......r..d?????", "#.............d?????", "#.............d?????",
	                              "#.............d?????", "#.............#?????", "###############?????",
	                              "????????????????????"};
	for (std::string& row : rows) std::ranges::replace(row, 'd', exit);
	return test::DrawnMap(rows, 0.2);
}

/** A mission that is told where the robot is. */
class ToldMission : public testing::Test
{
protected:
	void at(const Eigen::Vector3d& place, double yaw_rad)
	{
		MissionNow now;
		now.map_from_robot.translate(place).rotate(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
		now.t_s = m_t_s += 1.0;
		pursue(m_mission, m_memory, now, {}, {});
	}
	/** Stands there, a frame a second, for longer than the goal may take. */
	void waitInVainAt(const Eigen::Vector3d& place, double yaw_rad)
	{
		for (const double end_s = m_t_s + m_mission.goal->patience_s + 1.0; m_t_s < end_s;) at(place, yaw_rad);
	}
	/** Goes where the mission wants it until it no longer explores. Returns how often. */
	int lookUntilNothingIsLeft()
	{
		int looks = 0;
		while (m_mission.phase == MissionPhase::explore && looks < 50)
		{
			at(m_mission.goal->stand_in_map, m_mission.goal->yaw_rad);
			++looks;
		}
		return looks;
	}

	double m_t_s = 1000;
	Mission m_mission;
	FrontierMemory m_memory = test::memoryOf(roomWith('#'));
	const Eigen::Vector3d m_home = roomWith('#').at('h'), m_robot = roomWith('#').at('r');
};

TEST_F(ToldMission, NothingLeftMeansHomeAndHomeMeansDone)
{
	at(m_home, 0.0);
	at(m_robot, 0.5);
	EXPECT_EQ(m_mission.phase, MissionPhase::go_home);
	EXPECT_EQ(m_mission.end, MissionEnd::nothing_left);
	ASSERT_TRUE(m_mission.goal);
	EXPECT_EQ(m_mission.goal->kind, GoalKind::home);
	EXPECT_LT((m_mission.way_in_map.back() - m_home).norm(), 1e-9);
	at(m_home + Eigen::Vector3d(0.2, 0, 0), 0.0);
	EXPECT_EQ(m_mission.phase, MissionPhase::go_home) << "20 cm away";
	at(m_home + Eigen::Vector3d(0.03, 0, 0), 1.0);
	EXPECT_EQ(m_mission.phase, MissionPhase::done);
	const double path_m = m_mission.path_m;
	EXPECT_NEAR(path_m, 1.6 + 1.4 + 0.17, 1e-9);
	test::change(m_memory, roomWith('#'), roomWith('.'));
	at(m_home, 0.0);
	EXPECT_EQ(m_mission.phase, MissionPhase::done) << "done is done";
}

TEST_F(ToldMission, AnExitThatOpensOnTheWayHomeIsLookedAt)
{
	at(m_home, 0.0);
	at(m_robot, 0.0);
	ASSERT_EQ(m_mission.phase, MissionPhase::go_home);
	test::change(m_memory, roomWith('#'), roomWith('.'));
	at(m_robot, 0.0);
	EXPECT_EQ(m_mission.phase, MissionPhase::explore);
	EXPECT_EQ(m_mission.end, MissionEnd::none);
	ASSERT_TRUE(m_mission.goal);
	EXPECT_NE(m_mission.goal->kind, GoalKind::home);
	EXPECT_NEAR(m_mission.goal->frontier_in_map.x(), 2.9, 0.2);
}

TEST_F(ToldMission, AFrontierThatLooksDoNotMoveIsLeftAfterTwoAndTakenUpAgainWhenItHasMoved)
{
	test::change(m_memory, roomWith('#'), roomWith('.'));
	at(m_home, 0.0);
	ASSERT_EQ(m_mission.phase, MissionPhase::explore);
	EXPECT_LE(lookUntilNothingIsLeft(), 3);
	EXPECT_EQ(m_mission.end, MissionEnd::nothing_left);
	ASSERT_FALSE(m_mission.left_over.empty());
	for (const LeftOver& one : m_mission.left_over) EXPECT_EQ(one.why, LeftOverReason::sealed);
	// A metre more becomes known.
	test::DrawnMap more = roomWith('.');
	for (int column = 15; column < 19; ++column)
		for (int row = 3; row < 8; ++row) more.set(column, row, '.');
	test::change(m_memory, roomWith('.'), more);
	at(m_robot, 0.0);
	EXPECT_EQ(m_mission.phase, MissionPhase::explore);
}

TEST_F(ToldMission, AGoalStaysWhileNothingSpeaksAgainstItAndIsLostWhenTheMapShowsAll)
{
	test::change(m_memory, roomWith('#'), roomWith('.'));
	at(m_home, 0.0);
	ASSERT_TRUE(m_mission.goal);
	const Eigen::Vector3d stand = m_mission.goal->stand_in_map;
	const double yaw_rad = m_mission.goal->yaw_rad;
	for (int i = 1; i < 5; ++i)
	{
		at(m_home + Eigen::Vector3d(0.05 * i, 0, 0), 0.1 * i);
		ASSERT_TRUE(m_mission.goal);
		EXPECT_EQ(m_mission.goal->stand_in_map, stand);
		EXPECT_EQ(m_mission.goal->yaw_rad, yaw_rad);
		EXPECT_FALSE(m_mission.goal_lost);
	}
	test::DrawnMap all = roomWith('.');
	for (int row = 1; row < 12; ++row) all.set(15, row, '#');
	test::change(m_memory, roomWith('.'), all);
	at(m_home + Eigen::Vector3d(0.3, 0, 0), 0.0);
	EXPECT_TRUE(m_mission.goal_lost);
	EXPECT_EQ(m_mission.phase, MissionPhase::go_home);
}

TEST_F(ToldMission, WhatComesAndGoesWhileTheRobotStandsIsGivenUp)
{
	at(m_robot, 0.5);
	for (int i = 0; i < 4; ++i)
	{
		test::change(m_memory, roomWith('#'), roomWith('.'));
		at(m_robot, 0.5);
		test::change(m_memory, roomWith('.'), roomWith('#'));
		at(m_robot, 0.5);
	}
	test::change(m_memory, roomWith('#'), roomWith('.'));
	at(m_robot, 0.5);
	EXPECT_EQ(m_mission.end, MissionEnd::nothing_left);
}

/** A room with an exit at the right that the robot is near, and one at the left; each is open ('.') or not. */
test::DrawnMap roomWithTwo(char right, char left)
{
	std::vector<std::string> rows{"?????????????????????????????????????", "????############################?????",
	                              "????#..........................#?????", "????#..........................#?????",
	                              "????#..........................#?????", "????e..........................d?????",
	                              "????e...h...................r..d?????", "????e..........................d?????",
	                              "????e..........................d?????", "????e..........................d?????",
	                              "????#..........................#?????", "????############################?????",
	                              "?????????????????????????????????????"};
	for (std::string& row : rows)
	{
		std::ranges::replace(row, 'd', right);
		std::ranges::replace(row, 'e', left);
	}
	return test::DrawnMap(rows, 0.2);
}

TEST_F(ToldMission, AGoalThatTheMapTookAwayIsNotTakenUpAgainAtOnce)
{
	const test::DrawnMap both = roomWithTwo('.', '.'), left = roomWithTwo('#', '.');
	m_memory = test::memoryOf(both);
	const Eigen::Vector3d near_right = both.at('r');
	const auto goes_right = [&] { return m_mission.goal->frontier_in_map.x() > near_right.x(); };
	at(both.at('h'), 0.0);
	at(near_right, 0.0);
	ASSERT_TRUE(m_mission.goal);
	ASSERT_TRUE(goes_right());
	test::change(m_memory, both, left);
	at(near_right, 0.1);
	ASSERT_TRUE(m_mission.goal);
	ASSERT_FALSE(goes_right());
	test::change(m_memory, left, both);
	for (int second = 0; second < 15; ++second)
	{
		at(near_right, 0.1);
		ASSERT_TRUE(m_mission.goal);
		EXPECT_FALSE(goes_right()) << "a goal flip, " << second << " s after it was left";
	}
	m_t_s += 10.0;
	at(near_right, 0.1);
	ASSERT_TRUE(m_mission.goal);
	EXPECT_TRUE(goes_right()) << "it is nearer";
}

TEST_F(ToldMission, AGoalThatTakesTooLongIsGivenUp)
{
	test::change(m_memory, roomWith('#'), roomWith('.'));
	at(m_home, 3.0);
	ASSERT_TRUE(m_mission.goal);
	EXPECT_TRUE(m_mission.tried.empty());
	waitInVainAt(m_home, 3.0);
	EXPECT_FALSE(m_mission.tried.empty());
	at(m_home + Eigen::Vector3d(0.2, 0, 0), 3.0);
	ASSERT_TRUE(m_mission.goal);
	waitInVainAt(m_home, 3.0);
	EXPECT_EQ(m_mission.end, MissionEnd::nothing_left) << "twice in vain";
}

TEST_F(ToldMission, AGoalIsNotBlamedForTheTimeInWhichNoFramesCame)
{
	test::change(m_memory, roomWith('#'), roomWith('.'));
	at(m_home, 3.0);
	ASSERT_TRUE(m_mission.goal);
	const Eigen::Vector3d stand = m_mission.goal->stand_in_map;
	for (int outage = 0; outage < 3; ++outage)
	{
		m_t_s += 600.0;
		at(m_home, 3.0);
	}
	ASSERT_TRUE(m_mission.goal);
	EXPECT_EQ(m_mission.goal->stand_in_map, stand);
	EXPECT_TRUE(m_mission.tried.empty());
	EXPECT_EQ(m_mission.phase, MissionPhase::explore);
}

/** A robot that knows nothing but a cell or two around itself, walls nowhere. */
test::DrawnMap boxedIn()
{
	std::vector<std::string> rows(40, std::string(40, '?'));
	for (int row = 17; row < 23; ++row) rows[static_cast<std::size_t>(row)].replace(17, 6, "######");
	for (int row = 18; row < 22; ++row) rows[static_cast<std::size_t>(row)].replace(18, 4, "....");
	rows[20][20] = 'r';
	return test::DrawnMap(rows, 0.2);
}

TEST_F(ToldMission, ARobotThatFindsNoWayOnLooksAllAroundAndSaysSo)
{
	m_memory = test::memoryOf(boxedIn());
	const Eigen::Vector3d place = boxedIn().at('r');
	at(place, 0.0);
	std::set<int> directions;
	int looks = 0;
	for (; m_mission.phase == MissionPhase::explore && looks < 50; ++looks)
	{
		ASSERT_EQ(m_mission.goal->purpose, LookPurpose::way_out);
		EXPECT_LT((m_mission.goal->stand_in_map - place).head<2>().norm(), 0.1);
		directions.insert(static_cast<int>(std::lround(m_mission.goal->yaw_rad / 0.5)));
		at(place, m_mission.goal->yaw_rad);
	}
	EXPECT_GE(directions.size(), 6U) << "of 57 degrees each";
	EXPECT_LT(looks, 20);
	at(place, 0.0);
	EXPECT_EQ(m_mission.phase, MissionPhase::done) << "it is where it began";
	EXPECT_EQ(m_mission.end, MissionEnd::cut_off) << "which is not the end of an exploration";
}

TEST_F(ToldMission, ARobotThatIsCutOffFromHomeDoesNotSayThatNothingIsLeft)
{
	at(m_home, 0.0);
	at(m_robot, 0.0);
	ASSERT_EQ(m_mission.end, MissionEnd::nothing_left);
	test::DrawnMap divided = roomWith('#');
	for (int row = 0; row < divided.rows(); ++row) divided.set(7, row, '#');
	test::change(m_memory, roomWith('#'), divided);
	at(m_robot, 0.0);
	ASSERT_EQ(m_mission.phase, MissionPhase::explore);
	EXPECT_EQ(m_mission.goal->purpose, LookPurpose::way_out);
	for (int looks = 0; m_mission.phase == MissionPhase::explore && looks < 50; ++looks)
		at(m_robot, m_mission.goal->yaw_rad);
	EXPECT_EQ(m_mission.end, MissionEnd::cut_off);
	// What stood in the way goes away.
	test::change(m_memory, divided, roomWith('#'));
	at(m_robot, 0.0);
	EXPECT_EQ(m_mission.end, MissionEnd::nothing_left);
	EXPECT_TRUE(m_mission.goal->reachable);
}

TEST_F(ToldMission, ARobotThatIsCutOffFromHomeFacesWhatBarsTheWayAndWaits)
{
	const Eigen::Vector3d step = (m_robot - m_home) / 10.0;
	for (int i = 0; i <= 10; ++i) at(m_home + i * step, 0.0);
	test::DrawnMap divided = roomWith('#');
	const int column = 6;
	for (int row = 0; row < divided.rows(); ++row) divided.set(column, row, '#');
	test::change(m_memory, roomWith('#'), divided);
	do at(m_robot, m_mission.goal->yaw_rad);
	while (m_mission.phase == MissionPhase::explore);
	ASSERT_EQ(m_mission.goal->kind, GoalKind::home);
	EXPECT_FALSE(m_mission.goal->reachable);
	const Eigen::Vector3d barred = divided.middleOf(column, 5), stand = m_mission.goal->stand_in_map;
	EXPECT_GT(stand.x(), barred.x() + 0.8) << "nearer the camera measures nothing";
	EXPECT_LT(stand.x(), m_robot.x() + 0.1) << "on the way that it came by";
	EXPECT_NEAR(std::abs(m_mission.goal->yaw_rad), std::numbers::pi, 0.1);
	for (int second = 0; second < 60; ++second) at(stand, std::numbers::pi);
	EXPECT_EQ(m_mission.phase, MissionPhase::go_home) << "who stands there may walk on";
	for (int second = 0; second < 120; ++second) at(stand, std::numbers::pi);
	EXPECT_EQ(m_mission.phase, MissionPhase::done);
	EXPECT_FALSE(m_mission.home_reached);
}

TEST_F(ToldMission, ARobotThatDoesNotMoveAtAllLooksAroundBeforeItTriesAgain)
{
	test::change(m_memory, roomWith('#'), roomWith('.'));
	at(m_home, 3.0);
	ASSERT_TRUE(m_mission.goal);
	EXPECT_NE(m_mission.goal->purpose, LookPurpose::way_out);
	waitInVainAt(m_home, 3.0);
	ASSERT_TRUE(m_mission.goal);
	EXPECT_EQ(m_mission.goal->purpose, LookPurpose::way_out);
	at(m_home + Eigen::Vector3d(0.3, 0, 0), 0.0);
	ASSERT_TRUE(m_mission.goal);
	EXPECT_NE(m_mission.goal->purpose, LookPurpose::way_out) << "it can move";
}

/** A room and a hall behind its exit, which is open ('.') or not; the hall goes on to the right. */
test::DrawnMap roomAndHall(char exit)
{
	std::vector<std::string> rows{
	    "????????????????????????????", "###############?????????????", "#.............##############",
	    "#.............#.......??????", "#.............#.......??????", "#.............d.......??????",
	    "#..h..........d.......??????", "#.............d.......??????", "#.............d.......??????",
	    "#.............d.......??????", "#.............##############", "###############?????????????",
	    "????????????????????????????"};
	for (std::string& row : rows) std::ranges::replace(row, 'd', exit);
	return test::DrawnMap(rows, 0.2);
}

class MissionBeforeADoor : public ToldMission
{
protected:
	MissionBeforeADoor() { m_memory = test::memoryOf(roomAndHall('.')); }
	/** It has set out for the hall when someone steps into the door. Stands then where the mission wants it. */
	void loseTheHall()
	{
		at(m_home, 0.0);
		ASSERT_TRUE(m_mission.goal);
		ASSERT_GT(m_mission.goal->frontier_in_map.x(), m_door.x() + 0.5);
		test::change(m_memory, roomAndHall('.'), roomAndHall('#'));
		at(m_home, 0.0);
		ASSERT_EQ(m_mission.phase, MissionPhase::explore) << "who stands there may walk on";
		ASSERT_EQ(m_mission.goal->purpose, LookPurpose::barred_way);
		m_stand = m_mission.goal->stand_in_map;
		at(m_stand, m_mission.goal->yaw_rad);
	}

	const Eigen::Vector3d m_door = roomAndHall('.').middleOf(14, 7);
	Eigen::Vector3d m_stand = Eigen::Vector3d::Zero();
};

TEST_F(MissionBeforeADoor, WatchesFromTheWayWhatHasComeIntoIt)
{
	loseTheHall();
	const Eigen::Vector3d ahead = m_door - m_stand;
	EXPECT_GT(ahead.x(), 0.8) << "nearer the camera measures nothing";
	EXPECT_LT(ahead.norm(), 2.0);
	EXPECT_NEAR(m_mission.goal->yaw_rad, std::atan2(ahead.y(), ahead.x()), 0.5);
}

TEST_F(MissionBeforeADoor, GoesOnWhenTheWayIsFreeAgain)
{
	loseTheHall();
	for (int second = 0; second < 5; ++second) at(m_stand, m_mission.goal->yaw_rad);
	ASSERT_EQ(m_mission.goal->purpose, LookPurpose::barred_way);
	test::change(m_memory, roomAndHall('#'), roomAndHall('.'));
	at(m_stand, 0.0);
	ASSERT_EQ(m_mission.phase, MissionPhase::explore);
	EXPECT_EQ(m_mission.goal->purpose, LookPurpose::frontier);
	EXPECT_GT(m_mission.goal->frontier_in_map.x(), m_door.x() + 0.5);
}

TEST_F(MissionBeforeADoor, DoesNotWaitForEver)
{
	loseTheHall();
	int seconds = 0;
	for (; m_mission.phase == MissionPhase::explore && seconds < 100; ++seconds) at(m_stand, m_mission.goal->yaw_rad);
	EXPECT_GE(seconds, 15);
	EXPECT_LE(seconds, 30);
	EXPECT_EQ(m_mission.end, MissionEnd::nothing_left);
	ASSERT_EQ(m_mission.left_over.size(), 1U);
	EXPECT_EQ(m_mission.left_over.front().why, LeftOverReason::out_of_reach);
	at(m_home + Eigen::Vector3d(1, 0, 0), 0.0);
	EXPECT_EQ(m_mission.phase, MissionPhase::go_home);
}

/** The same; somebody stands in the exit, of 1 m, and leaves so many cells of 5 cm. */
test::DrawnMap roomAndHallBut(int cells_left)
{
	constexpr int kFiner = 4, kDoorColumn = 14, kDoorRow = 3, kDoorRows = 5;
	const test::DrawnMap coarse = roomAndHall('.');
	std::vector<std::string> rows;
	for (int row = kFiner * coarse.rows() - 1; row >= 0; --row)
	{
		const bool barred = row >= kFiner * kDoorRow + cells_left && row < kFiner * (kDoorRow + kDoorRows);
		rows.emplace_back();
		for (int column = 0; column < kFiner * coarse.columns(); ++column)
			rows.back() +=
			    barred && column / kFiner == kDoorColumn ? '#' : coarse.character(column / kFiner, row / kFiner);
	}
	return test::DrawnMap(rows);
}

TEST_F(MissionBeforeADoor, WatchesWhoLeavesTooLittleRoomToExploreBehind)
{
	const test::DrawnMap open = roomAndHallBut(20), barred = roomAndHallBut(9), roomy = roomAndHallBut(14);
	m_memory = test::memoryOf(open);
	at(open.at('h'), 0.0);
	ASSERT_TRUE(m_mission.goal);
	test::change(m_memory, open, barred);
	at(open.at('h'), 0.0);
	ASSERT_EQ(m_mission.phase, MissionPhase::explore);
	EXPECT_EQ(m_mission.goal->purpose, LookPurpose::barred_way);
	test::change(m_memory, barred, roomy);
	at(open.at('h'), 0.0);
	ASSERT_EQ(m_mission.phase, MissionPhase::explore);
	EXPECT_EQ(m_mission.goal->purpose, LookPurpose::frontier);
}

TEST_F(MissionBeforeADoor, DoesNotFollowWhoComesAndGoes)
{
	loseTheHall();
	int waits = 0;
	for (; m_mission.phase == MissionPhase::explore && waits < 20; ++waits)
	{
		m_mission.tried.clear();  // as if it were always elsewhere
		for (int second = 0; second < 12 && m_mission.phase == MissionPhase::explore; ++second)
			at(m_mission.goal->stand_in_map, m_mission.goal->yaw_rad);
	}
	EXPECT_LE(waits, 5);
	EXPECT_EQ(m_mission.end, MissionEnd::nothing_left);
}

TEST_F(MissionBeforeADoor, WhatIsSeenFromElsewhereIsNotWaitedFor)
{
	at(m_home, 0.0);
	test::DrawnMap all = roomAndHall('.'), all_but_the_door = roomAndHall('#');
	for (int row = 3; row < 10; ++row)
		for (int column = 22; column < 28; ++column)
			for (test::DrawnMap* map : {&all, &all_but_the_door}) map->set(column, row, '#');
	test::change(m_memory, roomAndHall('.'), all_but_the_door);
	at(m_home, 0.0);
	EXPECT_EQ(m_mission.phase, MissionPhase::go_home);
}

TEST(MissionEndName, IsWhatTheSummarySays)
{
	EXPECT_EQ(nameOf(MissionEnd::none), "");
	EXPECT_EQ(nameOf(MissionEnd::nothing_left), "nothing reachable left");
	EXPECT_EQ(nameOf(MissionEnd::time_budget), "time budget");
	EXPECT_EQ(nameOf(MissionEnd::path_budget), "path budget");
	EXPECT_EQ(nameOf(MissionEnd::cut_off), "no way on");
}
}  // namespace
}  // namespace explore
