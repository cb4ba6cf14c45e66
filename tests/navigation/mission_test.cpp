#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "navigation/mission_run.h"

namespace explore
{
namespace
{
/** 5.6 m × 4.2 m: three rooms off a corridor, a cupboard; 0.2 m a character. */
const test::DrawnMap kFlat({"############################",  //
                            "#........#.......#.........#",  //
                            "#........#.......#.........#",  //
                            "#........#.......#.........#",  //
                            "#........#...............###",  //
                            "#........#...............###",  //
                            "#........#...............###",  //
                            "#..............###.........#",  //
                            "#..............#.#.........#",  //
                            "#..............###.........#",  //
                            "#..............#.#.........#",  //
                            "####.....#######.###########",  //
                            "#..........................#",  //
                            "#..........................#",  //
                            "#..........................#",  //
                            "#..r.......................#",  //
                            "#..........................#",  //
                            "#..........................#",  //
                            "#..........................#",  //
                            "############################"},
                           0.2);

MissionConfig withPolicy(GoalPolicy policy)
{
	MissionConfig config;
	config.policy = policy;
	return config;
}

class MissionOf : public testing::TestWithParam<GoalPolicy>
{
};

TEST_P(MissionOf, SeesAllThereIsAndComesHome)
{
	test::MissionRun run(kFlat, withPolicy(GetParam()));
	run.run(900);
	ASSERT_TRUE(run.done()) << "after " << run.seconds() << " s";
	EXPECT_EQ(run.mission().end, MissionEnd::nothing_left);
	EXPECT_LT((run.robot() - kFlat.at('r')).norm(), 0.10);
	// The slit beside the cupboard is for nobody: 7 characters; corners may stay hidden.
	EXPECT_LT(run.freeButUnknown(), 12U);
	EXPECT_GT(run.leastClearance_m(), 0.22) << "the hull touched something";
	EXPECT_NEAR(run.mission().path_m, run.path_m(), 0.15 * run.path_m())
	    << "it is told where it is twice a second, and cuts corners in between";
	EXPECT_EQ(run.flips(), 0);
}

INSTANTIATE_TEST_SUITE_P(Policies, MissionOf, testing::Values(GoalPolicy::explore, GoalPolicy::nearest_frontier),
                         [](const auto& tested)
                         { return tested.param == GoalPolicy::explore ? "explore" : "nearest_frontier"; });

TEST(Mission, TheSameRunTwiceIsTheSame)
{
	test::MissionRun a(kFlat, {}), b(kFlat, {});
	for (int i = 0; i < 60; ++i)
	{
		a.tick();
		b.tick();
		ASSERT_EQ(a.robot(), b.robot());
		ASSERT_EQ(a.mission().way_in_map, b.mission().way_in_map);
	}
}

TEST(Mission, BeginsWithALookAroundAndKeepsItsGoalUntilItIsReached)
{
	test::MissionRun run(kFlat, {});
	run.tick();
	ASSERT_TRUE(run.mission().goal);
	EXPECT_EQ(run.mission().phase, MissionPhase::explore);
	EXPECT_GT(run.mission().open_frontiers, 0U);
	EXPECT_FALSE(run.mission().goal_lost);
}

TEST(Mission, TimeBudgetBringsItHomeInTime)
{
	MissionConfig config;
	config.budget.time_s = 30;
	test::MissionRun run(kFlat, config);
	run.run(900);
	ASSERT_TRUE(run.done());
	EXPECT_EQ(run.mission().end, MissionEnd::time_budget);
	EXPECT_LE(run.seconds(), 30.0 + 1.0);
	EXPECT_LT((run.robot() - kFlat.at('r')).norm(), 0.10);
}

TEST(Mission, PathBudgetBringsItHomeInTime)
{
	MissionConfig config;
	config.budget.path_m = 10;
	test::MissionRun run(kFlat, config);
	run.run(900);
	ASSERT_TRUE(run.done());
	EXPECT_EQ(run.mission().end, MissionEnd::path_budget);
	EXPECT_LE(run.mission().path_m, 10.0);
	EXPECT_GT(run.mission().path_m, 4.0) << "it went out at all";
	EXPECT_LT((run.robot() - kFlat.at('r')).norm(), 0.10);
}

TEST(Mission, BoundsKeepItIn)
{
	MissionConfig config;
	config.bounds = {.enabled = true, .min_x_m = 0.2, .max_x_m = 5.4, .min_y_m = 0.2, .max_y_m = 1.6, .keep_out = ""};
	test::MissionRun run(kFlat, config);
	double highest_m = 0.0;
	while (!run.done() && run.seconds() < 600)
	{
		run.tick();
		highest_m = std::max(highest_m, run.robot().y());
	}
	ASSERT_TRUE(run.done());
	EXPECT_LE(highest_m, 1.6);
	EXPECT_TRUE(std::ranges::any_of(run.mission().left_over,
	                                [](const LeftOver& one) { return one.why == LeftOverReason::outside_bounds; }));
}

/** A hall with something in it that gives nothing back, as glass does: what is there stays unknown for ever. */
const test::DrawnMap kHallWithGlass({"##############################",  //
                                     "#............................#",  //
                                     "#............................#",  //
                                     "#............................#",  //
                                     "#.................~~~~~~.....#",  //
                                     "#.................~~~~~~.....#",  //
                                     "#..r..............~~~~~~.....#",  //
                                     "#.................~~~~~~.....#",  //
                                     "#.................~~~~~~.....#",  //
                                     "#............................#",  //
                                     "#............................#",  //
                                     "#............................#",  //
                                     "##############################"},
                                    0.2);

TEST(Mission, WhatLookingDoesNotShowIsGivenUpAfterAFewLooksAndNamed)
{
	test::MissionRun run(kHallWithGlass, {});
	run.run(900);
	ASSERT_TRUE(run.done()) << "it looks for ever";
	EXPECT_EQ(run.mission().end, MissionEnd::nothing_left);
	const auto& left = run.mission().left_over;
	EXPECT_TRUE(std::ranges::any_of(left, [](const LeftOver& one) { return one.why == LeftOverReason::sealed; }));
	for (const TriedFrontier& tried : run.mission().tried) EXPECT_LE(tried.tries, 4);
}

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
	test::change(m_memory, roomWith('.'), roomWith('#'));
	at(m_home + Eigen::Vector3d(0.3, 0, 0), 0.0);
	EXPECT_TRUE(m_mission.goal_lost);
	EXPECT_EQ(m_mission.phase, MissionPhase::go_home);
}

TEST_F(ToldMission, AGoalThatTakesTooLongIsGivenUp)
{
	test::change(m_memory, roomWith('#'), roomWith('.'));
	at(m_home, 0.0);
	ASSERT_TRUE(m_mission.goal);
	m_t_s += m_mission.goal->patience_s + 1.0;
	at(m_home, 0.0);
	EXPECT_FALSE(m_mission.tried.empty());
	m_t_s += 1000.0;
	at(m_home + Eigen::Vector3d(0.2, 0, 0), 0.0);
	at(m_home, 0.0);
	EXPECT_EQ(m_mission.end, MissionEnd::nothing_left) << "twice in vain";
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
		ASSERT_TRUE(m_mission.goal->looks_around);
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
	EXPECT_TRUE(m_mission.goal->looks_around);
	for (int looks = 0; m_mission.phase == MissionPhase::explore && looks < 50; ++looks)
		at(m_robot, m_mission.goal->yaw_rad);
	EXPECT_EQ(m_mission.end, MissionEnd::cut_off);
	// What stood in the way goes away.
	test::change(m_memory, divided, roomWith('#'));
	at(m_robot, 0.0);
	EXPECT_EQ(m_mission.end, MissionEnd::nothing_left);
	EXPECT_TRUE(m_mission.goal->reachable);
}

TEST_F(ToldMission, ARobotThatDoesNotMoveAtAllLooksAroundBeforeItTriesAgain)
{
	test::change(m_memory, roomWith('#'), roomWith('.'));
	at(m_home, 3.0);
	ASSERT_TRUE(m_mission.goal);
	EXPECT_FALSE(m_mission.goal->looks_around);
	m_t_s += m_mission.goal->patience_s + 1.0;
	at(m_home, 3.0);
	ASSERT_TRUE(m_mission.goal);
	EXPECT_TRUE(m_mission.goal->looks_around);
	at(m_home + Eigen::Vector3d(0.3, 0, 0), 0.0);
	ASSERT_TRUE(m_mission.goal);
	EXPECT_FALSE(m_mission.goal->looks_around) << "it can move";
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
