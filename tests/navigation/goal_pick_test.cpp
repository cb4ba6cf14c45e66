#include <explore/navigation/goal_pick.h>
#include <gtest/gtest.h>

#include <numbers>

#include "support/drawn_map.h"

namespace explore
{
namespace
{
/** A corridor of 12 m along x; 0.2 m a character. Home is its left end. */
const test::DrawnMap kCorridor({std::string(60, '#'), "#" + std::string(58, '.') + "#",
                                "#" + std::string(58, '.') + "#", "#" + std::string(58, '.') + "#",
                                "#" + std::string(58, '.') + "#", "#" + std::string(58, '.') + "#",
                                "#" + std::string(58, '.') + "#", std::string(60, '#')},
                               0.2);
constexpr double kY_m = 0.825;

class GoalPick : public testing::Test
{
protected:
	/** The index that comes first for a robot at robot_x_m with goals along the corridor. */
	std::optional<std::size_t> first(double robot_x_m, const std::vector<double>& goals_x_m,
	                                 std::optional<std::size_t> current = {}, double home_x_m = 0.825)
	{
		const auto cell = [&](double x_m) { return m_map.cellOf({x_m, kY_m, 0}); };
		const TravelField field = travelFrom(m_map, cell(robot_x_m), {}, {});
		std::vector<LookTarget> targets;
		for (const double x_m : goals_x_m)
		{
			LookTarget& target = targets.emplace_back();
			target.left_lately = m_left_lately == targets.size() - 1;
			if (m_pocket_m2) target.pocket_m2 = *m_pocket_m2;
			target.look.cell = cell(x_m);
			target.stand_in_map = {x_m, kY_m, 0};
			target.travel_m = field.costTo(target.look.cell);
		}
		return firstOfTour({m_map, field, targets, 0.0, cell(home_x_m), current}, {}, {});
	}

	std::optional<std::size_t> m_left_lately;  ///< index of such a target
	std::optional<double> m_pocket_m2;         ///< of all targets
	AllowedArea m_area;
	BodyLayers m_layers = test::layersOf(kCorridor);
	PlanMap m_map = planMap({m_layers, m_area, {0.825, kY_m, 0}, {}, {}}, {}, {});
};

TEST_F(GoalPick, OnTheWayToHomeTheNearestComesFirst)
{
	EXPECT_EQ(first(1.0, {9.0, 3.0, 6.0}, {}, 11.0), 1U);
	EXPECT_EQ(first(1.0, {4.0}), 0U);
}

TEST_F(GoalPick, WhatLiesOnTheWayHomeIsLeftForTheWayHome)
{
	// The robot is in the middle; the nearer goal lies toward home, the farther one beyond.
	EXPECT_EQ(first(5.0, {4.0, 8.0}), 1U);
	// With home at the other end it is the other way round.
	EXPECT_EQ(first(5.0, {4.0, 8.0}, {}, 11.0), 0U);
}

TEST_F(GoalPick, TheCurrentGoalIsKeptUnlessAnotherOrderIsMuchShorter)
{
	// Toward home first costs 2 · 1 m more than the best order …
	EXPECT_EQ(first(5.0, {4.5, 8.0}, 0), 0U) << "1 m more is less than switch_gain";
	EXPECT_EQ(first(5.0, {3.5, 8.0}, 0), 1U) << "3 m more is not";
	EXPECT_EQ(first(5.0, {3.5, 8.0}, 1), 1U);
}

TEST_F(GoalPick, CutOffFromHomeTheCurrentGoalIsKept)
{
	const double beyond_the_wall_m = 20.0;
	EXPECT_EQ(first(6.0, {7.0, 8.0}, 1, beyond_the_wall_m), 1U);
	EXPECT_EQ(first(6.0, {7.0, 8.0}, 0, beyond_the_wall_m), 0U);
	EXPECT_EQ(first(6.0, {8.0, 7.0}, {}, beyond_the_wall_m), 1U) << "the nearest";
}

TEST_F(GoalPick, TheTurnCountsWhereTheWayIsTheSame)
{
	const CellIndex here = m_map.cellOf({5.0, kY_m, 0});
	const TravelField field = travelFrom(m_map, here, {}, {});
	LookTarget left, right;
	left.look = {here, 2.5};
	right.look = {here, -0.5};
	left.stand_in_map = right.stand_in_map = {5.0, kY_m, 0};
	const PickInput input{m_map, field, {left, right}, 0.0, here, std::nullopt};
	EXPECT_EQ(firstOfTour(input, {}, {}), 1U) << "half a radian first, then the rest";
}

TEST_F(GoalPick, WhatWasLeftLatelyComesFirstOnlyWhereThatSavesMuch)
{
	m_left_lately = 1;
	EXPECT_EQ(first(5.0, {4.5, 6.0}), 0U) << "1 m more is less than return_gain";
	EXPECT_EQ(first(5.0, {2.0, 9.0}), 1U) << "6 m more is not";
	EXPECT_EQ(first(5.0, {8.0}), 0U);
	m_left_lately = 0;
	EXPECT_EQ(first(5.0, {4.0}), 0U) << "there is nothing else";
}

TEST_F(GoalPick, APocketIsWorthSoMuchWayAndNoMore)
{
	m_pocket_m2 = 0.2;  // 2 m of way
	EXPECT_EQ(first(5.0, {5.8}), 0U) << "there and back 1.6 m";
	EXPECT_EQ(first(5.0, {6.4}), std::nullopt) << "2.8 m";
	EXPECT_EQ(first(5.0, {6.4}, 0), 0U) << "begun, it is gone on with, for up to switch_gain more";
	EXPECT_EQ(first(5.0, {7.5}, 0), std::nullopt);
	EXPECT_EQ(first(5.0, {1.5}), 0U) << "on the way home";
	EXPECT_EQ(first(5.0, {6.4, 6.5, 1.5}), 0U) << "two share a way";
	m_pocket_m2 = 1.0;
	EXPECT_EQ(first(5.0, {9.0}), 0U);
	m_pocket_m2.reset();
	EXPECT_EQ(first(5.0, {9.0}), 0U) << "without an end";
}

TEST_F(GoalPick, CutOffFromHomeNoPocketIsLeftOut)
{
	m_pocket_m2 = 0.01;
	EXPECT_EQ(first(6.0, {9.0}, {}, 20.0), 0U);
}

TEST_F(GoalPick, MoreGoalsThanATourTakesAreNoTrouble)
{
	std::vector<double> goals;
	for (int i = 0; i < 20; ++i) goals.push_back(1.5 + 0.5 * i);
	EXPECT_EQ(first(1.0, goals, {}, 11.0), 0U);
	EXPECT_EQ(first(1.0, goals, 0), 0U);
	EXPECT_LT(first(1.0, goals, 19).value(), 20U) << "the current one is among them however far it is";
	for (int i = 0; i < 80; ++i) goals.push_back(1.5 + 0.1 * i);
	EXPECT_LT(first(1.0, goals, 99).value(), 100U);
}

TEST(NearestTarget, IsTheOneWithTheLeastWay)
{
	std::vector<LookTarget> targets(3);
	targets[0].travel_m = 3;
	targets[1].travel_m = 1;
	targets[2].travel_m = 2;
	EXPECT_EQ(nearestTarget(targets), 1U);
}
}  // namespace
}  // namespace explore
