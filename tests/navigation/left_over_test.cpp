#include <explore/navigation/left_over.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/drawn_map.h"

namespace explore
{
namespace
{
/** A room, 0.2 m a character; what lies behind its right side differs from test to test. */
std::vector<std::string> room()
{
	return {"??????????????????????",  //
	        "############??????????",  //
	        "#..........#??????????",  //
	        "#..........#??????????",  //
	        "#..........#??????????",  //
	        "#..........#??????????",  //
	        "#....r.....#??????????",  //
	        "#..........#??????????",  //
	        "#..........#??????????",  //
	        "#..........#??????????",  //
	        "############??????????",  //
	        "??????????????????????"};
}
/** Replaces rows from `first` (from the top) on, at `column`. */
test::DrawnMap roomWith(std::size_t first, std::size_t column, const std::vector<std::string>& pieces)
{
	std::vector<std::string> rows = room();
	for (std::size_t i = 0; i < pieces.size(); ++i) rows[first + i].replace(column, pieces[i].size(), pieces[i]);
	return test::DrawnMap(rows, 0.2);
}
test::DrawnMap roomWithExit()
{
	return roomWith(4, 11, {".", ".", ".", ".", "."});
}

std::vector<LeftOver> accountOf(const test::DrawnMap& drawn, const AllowedArea& area = {},
                                const std::vector<DoorTrack>& doors = {},
                                std::optional<LeftOverReason> wanted = LeftOverReason::sealed,
                                const std::vector<Eigen::Vector3d>& passed_by = {})
{
	FrontierMemory memory = test::memoryOf(drawn);
	memory.doors.tracks = doors;
	const Eigen::Vector3d robot_in_map = drawn.at('r');
	const PlanMap map = planMap({memory.layers, area, robot_in_map, {}, {}}, {}, {});
	const TravelField field = travelFrom(map, map.cellOf(robot_in_map), {}, {});
	return leftOver({map, memory, field, area, wanted, passed_by});
}

/** All of them have one reason. */
void expectAll(const std::vector<LeftOver>& all, LeftOverReason why)
{
	EXPECT_FALSE(all.empty());
	for (const LeftOver& one : all) EXPECT_EQ(nameOf(one.why), nameOf(why)) << one.center_in_map.transpose();
}

DoorTrack doorSaying(Verdict verdict, bool confirmed = true)
{
	DoorTrack door;
	door.place.center_in_map = {2.3, 1.1};
	door.place.width_m = 0.9;
	door.existence.confirmed = confirmed;
	addOpinion(door.belief, {verdict, 0.0, 0.1, 1.0}, 0.8);
	return door;
}

TEST(LeftOver, AClosedRoomLeavesNothing)
{
	EXPECT_TRUE(accountOf(test::DrawnMap(room(), 0.2)).empty());
}

TEST(LeftOver, AnExitThatLookingDidNotOpenIsSealed)
{
	const auto all = accountOf(roomWithExit());
	expectAll(all, LeftOverReason::sealed);
	ASSERT_EQ(all.size(), 1U) << "neighbours are one";
	EXPECT_NEAR(all[0].area_m2, 20 * 0.05 * 0.05, 1e-9) << "a column of cells beside 1 m of frontier";
	EXPECT_LT((all[0].center_in_map.head<2>() - Eigen::Vector2d(2.425, 1.1)).norm(), 0.05);
}

TEST(LeftOver, WhatIsNotWorthTheWayWasPassedBy)
{
	const Eigen::Vector3d exit(2.375, 1.1, 0.0), elsewhere(0.5, 1.1, 0.0);
	for (const auto& [frontier, passed_by] : {std::pair(exit, true), std::pair(elsewhere, false)})
	{
		const auto all = accountOf(roomWithExit(), {}, {}, LeftOverReason::sealed, {frontier});
		expectAll(all, LeftOverReason::sealed);
		EXPECT_EQ(all.front().passed_by, passed_by);
	}
}

TEST(LeftOver, WhatWasNotYetLookedAtHasNoReason)
{
	EXPECT_TRUE(accountOf(roomWithExit(), {}, {}, std::nullopt).empty());
	expectAll(accountOf(roomWithExit(), {}, {doorSaying(Verdict::closed)}, std::nullopt), LeftOverReason::closed_door);
}

TEST(LeftOver, AGapThatTheRobotDoesNotFitThroughIsTooNarrow)
{
	expectAll(accountOf(roomWith(5, 11, {".", "."})), LeftOverReason::too_narrow);
}

TEST(LeftOver, WhatIsSeenThroughAWindowIsOutOfReach)
{
	// The next room is seen through a gap of 0.2 m; its right side is not.
	expectAll(accountOf(roomWith(1, 11,
	                             {"#########??", "#......????", "#......????", "#......????", "#......????",
	                              ".......????", "#......????", "#......????", "#......????", "#########??"})),
	          LeftOverReason::out_of_reach);
}

TEST(LeftOver, BoundsAndKeepOutNameWhatIsBehindThem)
{
	AllowedArea bounded;
	bounded.bounded = true;
	bounded.low = {0.0, 0.0};
	bounded.high = {2.4, 2.4};
	expectAll(accountOf(roomWithExit(), bounded), LeftOverReason::outside_bounds);
	AllowedArea fenced;
	fenced.keep_out = {{{2.4, 0.0}, {4.4, 0.0}, {4.4, 2.4}, {2.4, 2.4}}};
	expectAll(accountOf(roomWithExit(), fenced), LeftOverReason::kept_out);
}

TEST(LeftOver, UnknownBesideADropIsTheDrop)
{
	expectAll(accountOf(roomWith(4, 9, {"vv.", "vv.", "vv.", "vv.", "vv."})), LeftOverReason::drop);
}

TEST(LeftOver, ADoorThatCannotBePassedTellsWhy)
{
	for (const auto& [verdict, why] : {std::pair{Verdict::closed, LeftOverReason::closed_door},
	                                   {Verdict::blocked, LeftOverReason::closed_door},
	                                   {Verdict::unknown, LeftOverReason::behind_glass},
	                                   {Verdict::drop, LeftOverReason::drop},
	                                   {Verdict::open, LeftOverReason::sealed}})
		expectAll(accountOf(roomWithExit(), {}, {doorSaying(verdict)}), why);
	expectAll(accountOf(roomWithExit(), {}, {doorSaying(Verdict::closed, false)}), LeftOverReason::sealed);
}

TEST(LeftOver, EveryUnknownCellCountsOnce)
{
	// A frontier that goes around a corner and is cut into several clusters.
	const test::DrawnMap drawn(
	    {"????????????????????", "?..................?", "?..................?", "?.........r........?",
	     "?..................?", "?..................?", "????????????????????"},
	    0.2);
	double area_m2 = 0.0;
	for (const LeftOver& one : accountOf(drawn)) area_m2 += one.area_m2;
	EXPECT_NEAR(area_m2, 2 * (18 * 4 + 5 * 4) * 0.05 * 0.05, 1e-9) << "all around, without the corners";
}

TEST(LeftOver, PlacesFarApartAreTwo)
{
	const auto all = accountOf(roomWith(1, 2, {"##..######", "#"}).with(4, 1, '.').with(5, 1, '.'));
	EXPECT_EQ(all.size(), 2U);
}

TEST(LeftOverReason, HasTheNamesOfTheContract)
{
	EXPECT_EQ(nameOf(LeftOverReason::sealed), "sealed");
	EXPECT_EQ(nameOf(LeftOverReason::too_narrow), "too_narrow");
	EXPECT_EQ(nameOf(LeftOverReason::out_of_reach), "out_of_reach");
	EXPECT_EQ(nameOf(LeftOverReason::closed_door), "closed_door");
	EXPECT_EQ(nameOf(LeftOverReason::behind_glass), "behind_glass");
	EXPECT_EQ(nameOf(LeftOverReason::drop), "drop");
	EXPECT_EQ(nameOf(LeftOverReason::kept_out), "kept_out");
	EXPECT_EQ(nameOf(LeftOverReason::outside_bounds), "outside_bounds");
}
}  // namespace
}  // namespace explore
