#include <gtest/gtest.h>

#include <algorithm>

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

/** A room of 7 m with a shelf in it that is open to the far side; 0.2 m a character. */
const test::DrawnMap kShelf({"###################################",  //
                             "#.................................#",  //
                             "#.................................#",  //
                             "#.................................#",  //
                             "#.................................#",  //
                             "#.................................#",  //
                             "#.....................######......#",  //
                             "#.....................#...........#",  //
                             "#..r..................#...........#",  //
                             "#.....................#...........#",  //
                             "#.....................#...........#",  //
                             "#.....................######......#",  //
                             "#.................................#",  //
                             "#.................................#",  //
                             "#.................................#",  //
                             "#.................................#",  //
                             "#.................................#",  //
                             "###################################"},
                            0.2);

TEST(Mission, LooksFromNearerWhereALookFromAfarShowedNothing)
{
	MissionConfig config;
	config.plan.view_range_m = 4.8;  // the camera sees 4 m
	test::MissionRun run(kShelf, config);
	run.run(900);
	ASSERT_TRUE(run.done());
	EXPECT_LT(run.freeButUnknown(), 30U) << "of 560";
}

TEST(Mission, PassesByWhatIsNotWorthTheWayAndSaysSo)
{
	const auto passed_by = [](const test::MissionRun& run)
	{
		return std::ranges::count_if(run.mission().left_over, [](const LeftOver& left)
		                             { return left.passed_by && left.why == LeftOverReason::sealed; });
	};
	MissionConfig thorough, hasty;
	thorough.plan.pocket_worth = 1e6;
	hasty.plan.pocket_worth = 2.0;
	test::MissionRun all(kShelf, thorough), most(kShelf, hasty);
	all.run(900);
	most.run(900);
	ASSERT_TRUE(all.done() && most.done());
	EXPECT_EQ(most.mission().end, MissionEnd::nothing_left);
	EXPECT_EQ(passed_by(all), 0);
	EXPECT_GT(passed_by(most), 0);
	EXPECT_LT(most.path_m(), all.path_m());
	EXPECT_LT(most.freeButUnknown(), 40U) << "1.6 of 20 m²: the shelf, and what lies behind it";
}

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
}  // namespace
}  // namespace explore
