#include <explore/navigation/look_targets.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/drawn_map.h"

namespace explore
{
namespace
{
/** A room with an exit of 1 m to the right and one of 1 m to the top, and a window to the left that nobody gets
 *  through; 0.2 m a character. */
const test::DrawnMap kTwoExits({"?????????????????????????",  //
                                "???#########.....####????",  //
                                "???#................#????",  //
                                "???#................#????",  //
                                "???#................#????",  //
                                "???#................#????",  //
                                "???#................#????",  //
                                "???...r..............????",  //
                                "???#.................????",  //
                                "???#.................????",  //
                                "???#.................????",  //
                                "???#.................????",  //
                                "???#................#????",  //
                                "???#................#????",  //
                                "???##################????"},
                               0.2);

/** All that is needed to choose looks in a drawing. */
struct Scene
{
	explicit Scene(const test::DrawnMap& drawn, const Eigen::Vector3d& robot_in_map)
	    : memory(test::memoryOf(drawn)),
	      map(planMap({memory.layers, area, robot_in_map, {}, {}}, {}, {})),
	      field(travelFrom(map, map.cellOf(robot_in_map), {}, {})),
	      frontiers(wantedFrontiers(map, memory.frontiers.clusters()))
	{
	}
	/** The frontier that is nearest to a point. */
	[[nodiscard]] const WantedFrontier& frontierAt(const Eigen::Vector3d& point_in_map) const
	{
		const auto away = [&](const WantedFrontier& frontier)
		{ return (frontier.middle_in_map - point_in_map).norm(); };
		return *std::min_element(frontiers.begin(), frontiers.end(),
		                         [&](const auto& a, const auto& b) { return away(a) < away(b); });
	}

	AllowedArea area;
	FrontierMemory memory;
	PlanMap map;
	TravelField field;
	std::vector<WantedFrontier> frontiers;
};

const Eigen::Vector3d kRight(4.1, 1.1, 0), kTop(2.9, 2.7, 0);

TEST(WantedFrontiers, AreTheEdgesThatTheBodyGetsThrough)
{
	const Scene scene(kTwoExits, kTwoExits.at('r'));
	ASSERT_EQ(scene.frontiers.size(), 2U) << "the window is no way";
	for (const WantedFrontier& frontier : scene.frontiers)
	{
		const bool right = (frontier.middle_in_map - kRight).norm() < 0.4;
		const bool top = (frontier.middle_in_map - kTop).norm() < 0.4;
		EXPECT_TRUE(right || top) << frontier.middle_in_map.transpose();
		EXPECT_TRUE(
		    std::ranges::all_of(frontier.cells, [&](CellIndex cell) { return scene.map.near_wanted[cell] != 0; }));
		EXPECT_NE(std::ranges::find(frontier.cells, scene.map.cellOf(frontier.middle_in_map)), frontier.cells.end())
		    << "the middle is one of its cells";
	}
}

TEST(WantedFrontiers, NothingIsWantedInAClosedRoom)
{
	const test::DrawnMap closed({"##########", "#........#", "#...r....#", "#........#", "#........#", "##########"},
	                            0.2);
	EXPECT_TRUE(Scene(closed, closed.at('r')).frontiers.empty());
}

/** What a look must keep, whatever is best. */
void expectGoodLook(const Scene& scene, const LookTarget& target, const WantedFrontier& frontier)
{
	EXPECT_TRUE(scene.map.passable[target.look.cell]);
	EXPECT_TRUE(scene.field.reaches(target.look.cell));
	EXPECT_EQ(target.stand_in_map, scene.map.middleOf(target.look.cell));
	EXPECT_EQ(target.frontier_in_map, frontier.middle_in_map);
	const Eigen::Vector3d toward = target.frontier_in_map - target.stand_in_map;
	EXPECT_NEAR(target.look.yaw_rad, std::atan2(toward.y(), toward.x()), 1e-9) << "it looks at the frontier";
	EXPECT_DOUBLE_EQ(target.travel_m, scene.field.costTo(target.look.cell));
	EXPECT_NEAR(target.gain_m2, lookGain(scene.map, target.look, {}), 1e-12);
	EXPECT_GE(target.gain_m2, PlanConfig().min_gain_m2);
}

/** Two rooms side by side with a door in between, 0.2 m a character. Of the upper one its left is not known, nor the
 *  middle of the lower one beside it: a place in the lower room that looks at the upper frontier shows the unknown of
 *  its own room. */
const test::DrawnMap kTwoRooms({"########################",  //
                                "#?????.................#",  //
                                "#?????.................#",  //
                                "#?????.................#",  //
                                "#?????.................#",  //
                                "#?????.................#",  //
                                "#?????.................#",  //
                                "#?????.........r.......#",  //
                                "#?????.................#",  //
                                "###############.....####",  //
                                "#......????????........#",  //
                                "#......????????........#",  //
                                "#......????????........#",  //
                                "#......................#",  //
                                "#......................#",  //
                                "#......................#",  //
                                "########################"},
                               0.2);

TEST(BestLook, IsOneThatSeesItsFrontierNotTheWallBeforeIt)
{
	const Scene scene(kTwoRooms, kTwoRooms.at('r'));
	const WantedFrontier& frontier = scene.frontierAt({1.3, 2.4, 0});
	ASSERT_GT(frontier.middle_in_map.y(), 1.6) << "of the upper room";
	const auto best = bestLook(scene.map, scene.field, frontier, {});
	ASSERT_TRUE(best);
	EXPECT_GT(best->stand_in_map.y(), 1.6) << "in the upper room";
	EXPECT_TRUE(sees(scene.map, best->look, frontier.middle_in_map, {}));
}

TEST(BestLook, ShowsAGoodShareOfWhatAnyPlaceShowsAndNeedNotGoAllTheWay)
{
	const Scene scene(kTwoExits, kTwoExits.at('r'));
	for (const Eigen::Vector3d& exit : {kRight, kTop})
	{
		const WantedFrontier& frontier = scene.frontierAt(exit);
		const auto best = bestLook(scene.map, scene.field, frontier, {});
		ASSERT_TRUE(best);
		expectGoodLook(scene, *best, frontier);
		// Of all cells within 3 m, not only of those that are tried.
		double most_m2 = 0.0;
		for (CellIndex cell = 0; cell < scene.map.cells.size(); ++cell)
		{
			const Eigen::Vector3d toward = frontier.middle_in_map - scene.map.middleOf(cell);
			if (!scene.map.passable[cell] || !scene.field.reaches(cell) || toward.norm() > 3.0) continue;
			most_m2 = std::max(most_m2, lookGain(scene.map, {cell, std::atan2(toward.y(), toward.x())}, {}));
		}
		EXPECT_GE(best->gain_m2, 0.3 * most_m2);
		EXPECT_LT(best->travel_m,
		          scene.field.costTo(scene.map.cellOf(exit - 0.4 * (exit - kTwoExits.at('r')).normalized())))
		    << "it need not go all the way";
	}
}

TEST(BestLook, IsATurnWhereTheRobotStandsWhenThatShowsEnough)
{
	// A room of 2 m × 1.4 m that is open above.
	std::vector<std::string> rows(30, std::string(40, '?'));
	for (std::size_t row = 8; row < 23; ++row) rows[row].replace(9, 22, "#" + std::string(20, '.') + "#");
	rows[22].replace(9, 22, std::string(22, '#'));
	const test::DrawnMap drawn(rows, 0.1);
	const Eigen::Vector3d robot_in_map(2.0, 1.5, 0.0);
	const Scene scene(drawn, robot_in_map);
	const auto best = bestLook(scene.map, scene.field, scene.frontierAt({2.0, 2.2, 0.0}), {});
	ASSERT_TRUE(best);
	EXPECT_LT((best->stand_in_map - robot_in_map).norm(), 0.6) << "half a metre for a better view";
	EXPECT_NEAR(best->look.yaw_rad, 0.5 * std::numbers::pi, 0.9);
}

TEST(BestLook, IsNothingWhereNothingWouldBeSeen)
{
	const Scene scene(kTwoExits, kTwoExits.at('r'));
	PlanConfig asks_much;
	asks_much.min_gain_m2 = 50.0;
	EXPECT_FALSE(bestLook(scene.map, scene.field, scene.frontierAt(kRight), asks_much));
	const TravelField nowhere = travelFrom(scene.map, kNoCell, {}, {});
	EXPECT_FALSE(bestLook(scene.map, nowhere, scene.frontierAt(kRight), {})) << "it cannot get there";
}

TEST(NearestPlace, IsTheReachableCellNearestToTheFrontier)
{
	const Scene scene(kTwoExits, kTwoExits.at('r'));
	const WantedFrontier& frontier = scene.frontierAt(kRight);
	const auto place = nearestPlace(scene.map, scene.field, frontier, {});
	ASSERT_TRUE(place);
	expectGoodLook(scene, *place, frontier);
	const double away_m = (place->stand_in_map - frontier.middle_in_map).norm();
	for (CellIndex cell = 0; cell < scene.map.cells.size(); ++cell)
	{
		const bool could_stand = scene.map.passable[cell] != 0 && scene.field.reaches(cell);
		ASSERT_TRUE(!could_stand || (scene.map.middleOf(cell) - frontier.middle_in_map).norm() > away_m - 1e-9);
	}
}

TEST(WithoutRedundant, KeepsOneOfLooksThatShowTheSame)
{
	const Scene scene(kTwoExits, kTwoExits.at('r'));
	const auto right = bestLook(scene.map, scene.field, scene.frontierAt(kRight), {});
	const auto top = bestLook(scene.map, scene.field, scene.frontierAt(kTop), {});
	ASSERT_TRUE(right && top);
	LookTarget beside = *right;  // a frontier 20 cm beside, worth less
	beside.frontier_in_map.y() += 0.2;
	beside.gain_m2 *= 0.5;
	const auto kept = withoutRedundant(scene.map, {beside, *top, *right}, {});
	ASSERT_EQ(kept.size(), 2U);
	for (const LookTarget& target : {*right, *top})
		EXPECT_TRUE(std::ranges::any_of(
		    kept, [&](const LookTarget& other) { return other.frontier_in_map == target.frontier_in_map; }));
	EXPECT_TRUE(withoutRedundant(scene.map, {}, {}).empty());
}
}  // namespace
}  // namespace explore
