#include <explore/navigation/pockets.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "support/drawn_map.h"
#include "support/random_points.h"

namespace explore
{
namespace
{
PlanMap mapOf(const test::DrawnMap& drawn, const RobotConfig& robot = {})
{
	const BodyLayers layers = test::layersOf(drawn, robot);
	return planMap({layers, AllowedArea(), drawn.at('r'), {}, {}}, robot, {});
}

/** The pocket of a point. */
double areaAt(const PlanMap& map, const Pockets& pockets, double x_m, double y_m, double z_m = 0.0)
{
	return pockets.area_m2[pockets.number[map.cellOf({x_m, y_m, z_m})]];
}

/** A room of 6 m × 4 m; 0.2 m a character. A nook in the middle that was not looked into, and an exit to the right. */
const test::DrawnMap kRoomWithNook({"????????????????????????????????????",  //
                                    "################################????",  //
                                    "#..............................#????",  //
                                    "#..............................#????",  //
                                    "#..............................#????",  //
                                    "#..............................#????",  //
                                    "#..............................#????",  //
                                    "#............??????............#????",  //
                                    "#....r.......??????.............????",  //
                                    "#............??????.............????",  //
                                    "#............??????.............????",  //
                                    "#............??????.............????",  //
                                    "#..............................#????",  //
                                    "#..............................#????",  //
                                    "#..............................#????",  //
                                    "#..............................#????",  //
                                    "################################????",  //
                                    "????????????????????????????????????"},
                                   0.2);

TEST(Pockets, AreAsLargeAsWhatIsUnknownInThem)
{
	const PlanMap map = mapOf(kRoomWithNook);
	const Pockets pockets = pocketsOf(map);
	EXPECT_NEAR(areaAt(map, pockets, 3.1, 1.7), 6 * 5 * 0.2 * 0.2, 1e-9) << "6 by 5 characters";
	EXPECT_EQ(areaAt(map, pockets, 1.1, 1.9), 0.0) << "known";
	EXPECT_EQ(areaAt(map, pockets, 6.3, 0.3), 0.0) << "a wall";
}

TEST(Pockets, WhatGoesOnBeyondTheMapHasNoEnd)
{
	const PlanMap map = mapOf(kRoomWithNook);
	const Pockets pockets = pocketsOf(map);
	EXPECT_TRUE(std::isinf(areaAt(map, pockets, 6.7, 1.7))) << "through the exit";
}

TEST(Pockets, BesideAFrontierCountOnceEach)
{
	const PlanMap map = mapOf(kRoomWithNook);
	const Pockets pockets = pocketsOf(map);
	const CellIndex left = map.cellOf({2.575, 1.5, 0}), left_too = map.cellOf({2.575, 1.7, 0});
	const CellIndex exit = map.cellOf({6.375, 1.7, 0}), open = map.cellOf({1.1, 1.1, 0});
	EXPECT_NEAR(pockets.besideThose(map, {left, left_too}), 1.2, 1e-9);
	EXPECT_TRUE(std::isinf(pockets.besideThose(map, {left, exit})));
	EXPECT_EQ(pockets.besideThose(map, {open}), 0.0);
	EXPECT_EQ(pockets.besideThose(map, {}), 0.0);
}

TEST(Pockets, OfAMavAreAreasOfFloorToo)
{
	RobotConfig mav;
	mav.kind = RobotKind::mav;
	const PlanMap map = mapOf(kRoomWithNook, mav);
	ASSERT_GT(map.frame.altitudes_m.size(), 1U);
	EXPECT_NEAR(areaAt(map, pocketsOf(map), 3.1, 1.7, map.frame.altitudes_m.front()), 1.2, 1e-9)
	    << "the same at each height";
}

/** Numbers by the slow way: neighbours take the smaller number of the two, until nothing changes. */
std::vector<std::uint32_t> joinedSlowly(const PlanMap& map)
{
	std::vector<std::uint32_t> number(map.cells.size());
	std::iota(number.begin(), number.end(), 0U);
	for (bool changed = true; changed;)
	{
		changed = false;
		for (CellIndex cell = 0; cell < map.cells.size(); ++cell)
			forEachNext(map, cell,
			            [&](CellIndex next)
			            {
				            if (map.wanted[cell] == 0 || map.wanted[next] == 0 || number[next] <= number[cell]) return;
				            number[next] = number[cell];
				            changed = true;
			            });
	}
	return number;
}

TEST(Pockets, AreWhatIsJoinedInRandomMaps)
{
	std::mt19937 random(5);
	for (int trial = 0; trial < 40; ++trial)
	{
		SCOPED_TRACE(trial);
		std::vector<std::string> rows(30, std::string(40, '.'));
		for (std::string& row : rows)
			for (char& character : row)
				if (test::uniform(random, 0, 1) < 0.45) character = '?';
		rows[15][20] = 'r';
		const PlanMap map = mapOf(test::DrawnMap(rows));
		const Pockets pockets = pocketsOf(map);
		const std::vector<std::uint32_t> joined = joinedSlowly(map);
		std::map<std::uint32_t, double> area_m2;
		std::map<std::uint32_t, std::uint32_t> of_joined;
		for (CellIndex cell = 0; cell < map.cells.size(); ++cell)
		{
			ASSERT_EQ(pockets.number[cell] != 0, map.wanted[cell] != 0);
			if (map.wanted[cell] == 0) continue;
			area_m2[joined[cell]] += 0.05 * 0.05;
			ASSERT_EQ(of_joined.emplace(joined[cell], pockets.number[cell]).first->second, pockets.number[cell]);
		}
		ASSERT_EQ(of_joined.size() + 1, pockets.area_m2.size());
		for (const auto& [first, number] : of_joined)
		{
			if (std::isinf(pockets.area_m2[number])) continue;
			EXPECT_NEAR(pockets.area_m2[number], area_m2[first], 1e-9);
		}
	}
}
}  // namespace
}  // namespace explore
