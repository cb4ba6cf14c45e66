#include <explore/navigation/travel_field.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/drawn_map.h"

namespace explore
{
namespace
{
constexpr double kCell_m = 0.05;

/** Cells at random, with all that a plan says of them; `layers` of 0.25 m. */
PlanMap randomPlan(std::mt19937& random, int columns, int rows, int layers)
{
	PlanMap map;
	map.frame.resolution_m = kCell_m;
	map.frame.columns = columns;
	map.frame.rows = rows;
	for (int layer = 0; layer < layers; ++layer) map.frame.altitudes_m.push_back(0.5 + 0.25 * layer);
	map.fit_m = 0.27;
	const auto chance = [&](unsigned per_cent) { return random() % 100 < per_cent; };
	for (std::size_t i = 0; i < map.frame.size(); ++i)
	{
		map.cells.push_back(chance(75) ? CellState::free : chance(50) ? CellState::unknown : CellState::occupied);
		map.passable.push_back(map.cells.back() == CellState::free && chance(80) ? 1 : 0);
		map.blocked.push_back(chance(5) ? 1 : 0);
		map.obstacle_m.push_back(0.05F * static_cast<float>(random() % 12));
		map.allowed.push_back(1);
	}
	return map;
}

/** What a step into a cell costs beside one in the open; 0 = it is no way. */
double weightOf(const PlanMap& map, CellIndex cell, CellIndex start, const RobotConfig& robot, const PlanConfig& config)
{
	if (map.passable[cell] == 0)
	{
		const Eigen::Vector3d off = map.middleOf(cell) - map.middleOf(start);
		const bool beneath = off.z() == 0.0 && off.head<2>().norm() <= robot.radius_m + 1e-9;
		return beneath && map.cells[cell] == CellState::free ? 5.0 : 0.0;
	}
	if (map.blocked[cell] != 0) return 20.0;
	const double least_m = robot.radius_m + config.squeeze_m;
	const double nearness = (config.comfort_m - map.obstacle_m[cell]) / (config.comfort_m - least_m);
	return 1.0 + config.clearance_cost * std::clamp(nearness, 0.0, 1.0);
}

/** Tenths of a cell's edge for a step between neighbours; 0 where they are none. */
double stepBetween(const PlanMap& map, CellIndex a, CellIndex b)
{
	const Eigen::Array3i off = (map.placeOf(a) - map.placeOf(b)).abs();
	if (off.z() == 0 && off.head<2>().maxCoeff() == 1) return off.head<2>().sum() == 2 ? 14 : 10;
	return off.z() == 1 && off.head<2>().maxCoeff() == 0 ? 10 * 1.5 * 5 : 0;
}

/** Costs by relaxing every step again and again until nothing changes (Bellman & Ford). */
std::vector<std::uint32_t> slowCosts(const PlanMap& map, CellIndex start, const RobotConfig& robot,
                                     const PlanConfig& config)
{
	std::vector<std::uint32_t> costs(map.cells.size(), kUnreached);
	costs[start] = 0;
	for (bool changed = true; changed;)
	{
		changed = false;
		for (CellIndex to = 0; to < costs.size(); ++to)
		{
			const double weight = weightOf(map, to, start, robot, config);
			if (weight == 0.0) continue;
			for (CellIndex from = 0; from < costs.size(); ++from)
			{
				const double step = stepBetween(map, from, to);
				if (step == 0.0 || costs[from] == kUnreached) continue;
				const auto cost = costs[from] + static_cast<std::uint32_t>(std::lround(std::lround(step) * weight));
				if (cost >= costs[to]) continue;
				costs[to] = cost;
				changed = true;
			}
		}
	}
	return costs;
}

/** From cell to neighbouring cell, from the start, over nothing that is no way. */
void expectWay(const TravelField& field, const PlanMap& map, CellIndex cell, const RobotConfig& robot,
               const PlanConfig& config)
{
	const std::vector<CellIndex> way = field.wayTo(cell);
	ASSERT_FALSE(way.empty());
	EXPECT_EQ(way.front(), field.start);
	EXPECT_EQ(way.back(), cell);
	std::uint32_t cost = 0;
	for (std::size_t i = 1; i < way.size(); ++i)
	{
		const double step = stepBetween(map, way[i - 1], way[i]),
		             weight = weightOf(map, way[i], field.start, robot, config);
		ASSERT_GT(step, 0.0) << "no neighbours";
		ASSERT_GT(weight, 0.0) << "no way";
		cost += static_cast<std::uint32_t>(std::lround(std::lround(step) * weight));
	}
	EXPECT_EQ(cost, field.cost[cell]);
}

TEST(TravelField, CostsAreTheLeastOfAllWays)
{
	std::mt19937 random(21);
	std::size_t reached = 0;
	for (int trial = 0; trial < 60; ++trial)
	{
		SCOPED_TRACE(trial);
		const int layers = trial % 5 == 0 ? 3 : 1;
		const PlanMap map =
		    randomPlan(random, 6 + static_cast<int>(random() % 8), 5 + static_cast<int>(random() % 8), layers);
		RobotConfig robot;
		robot.radius_m = 0.12;
		PlanConfig config;
		config.clearance_cost = trial % 3;
		const auto start = static_cast<CellIndex>(random() % map.cells.size());
		const TravelField field = travelFrom(map, start, robot, config);
		ASSERT_EQ(field.cost, slowCosts(map, start, robot, config));
		for (CellIndex cell = 0; cell < map.cells.size(); ++cell)
		{
			EXPECT_EQ(field.reaches(cell), field.cost[cell] != kUnreached);
			EXPECT_NE(field.wayTo(cell).empty(), field.reaches(cell));
			if (!field.reaches(cell)) continue;
			expectWay(field, map, cell, robot, config);
			if (testing::Test::HasFatalFailure()) return;
			++reached;
		}
	}
	EXPECT_GT(reached, 2000U) << "the test saw too little";
}

PlanMap planOf(const test::DrawnMap& drawn, const Eigen::Vector3d& robot_in_map,
               const std::vector<Eigen::Vector3d>& blocked = {})
{
	const AllowedArea everywhere;
	const BodyLayers layers = test::layersOf(drawn);
	return planMap({layers, everywhere, robot_in_map, {}, blocked}, {}, {});
}

TEST(TravelField, NoWayLeadsFromNowhere)
{
	const PlanMap map = planOf(test::DrawnMap({"...", "...", "..."}, 0.5), {0.7, 0.7, 0});
	const TravelField field = travelFrom(map, kNoCell, {}, {});
	EXPECT_FALSE(field.reaches(map.cellOf({0.7, 0.7, 0})));
	EXPECT_FALSE(field.reaches(kNoCell));
}

/** 6 m × 3 m in all with a wall across the middle; 0.2 m a character. */
const test::DrawnMap kTwoRooms({"##############################",  //
                                "#.............#..............#",  //
                                "#.............#..............#",  //
                                "#.............#..............#",  //
                                "#.............#..............#",  //
                                "#.............#..............#",  //
                                "#.............#........b.....#",  //
                                "#.............#..............#",  //
                                "#.............#..............#",  //
                                "#.............#..............#",  //
                                "#.............#..............#",  //
                                "#............................#",  //
                                "#...a........................#",  //
                                "#............................#",  //
                                "#............................#",  //
                                "#............................#",  //
                                "##############################"},
                               0.2);

TEST(TravelField, ADoorwayThatIsWideEnoughJoinsRooms)
{
	const PlanMap map = planOf(kTwoRooms, kTwoRooms.at('a'));
	const CellIndex to = map.cellOf(kTwoRooms.at('b'));
	const TravelField field = travelFrom(map, map.cellOf(kTwoRooms.at('a')), {}, {});
	ASSERT_TRUE(field.reaches(to));
	EXPECT_GT(field.costTo(to), (kTwoRooms.at('b') - kTwoRooms.at('a')).norm());
	const TravelField shut =
	    travelFrom(planOf(kTwoRooms.with(14, 4, '#').with(14, 5, '#'), kTwoRooms.at('a')), field.start, {}, {});
	EXPECT_TRUE(shut.reaches(to)) << "0.6 m are left of it";
	const TravelField narrow = travelFrom(
	    planOf(kTwoRooms.with(14, 3, '#').with(14, 4, '#').with(14, 5, '#'), kTwoRooms.at('a')), field.start, {}, {});
	EXPECT_FALSE(narrow.reaches(to)) << "0.4 m are not enough";
}

TEST(TravelField, ARobotThatStandsTooNearToAThingMayLeave)
{
	const Eigen::Vector3d robot_in_map(0.325, 0.625, 0.0);  // 0.15 m from the wall's middle
	const PlanMap map = planOf(kTwoRooms, robot_in_map);
	const CellIndex start = map.cellOf(robot_in_map);
	ASSERT_FALSE(map.passable[start]);
	const TravelField field = travelFrom(map, start, {}, {});
	EXPECT_TRUE(field.reaches(map.cellOf(kTwoRooms.at('a'))));
	EXPECT_FALSE(field.reaches(map.cellOf({0.325, 1.625, 0.0}))) << "as near to the wall, further along";
}

TEST(TravelField, WaysKeepTheirDistanceWhereThereIsRoom)
{
	const PlanMap map = planOf(kTwoRooms, kTwoRooms.at('a'));
	const TravelField field = travelFrom(map, map.cellOf(kTwoRooms.at('a')), {}, {});
	float nearest_m = 1.0F;
	for (const CellIndex cell : field.wayTo(map.cellOf(kTwoRooms.at('b'))))
		nearest_m = std::min(nearest_m, map.obstacle_m[cell]);
	EXPECT_GE(nearest_m, 0.39F) << "it passes a corner with room all around";
}

/** Whether any point of a polyline lies within `radius_m` of `spot`. */
bool passesNear(const std::vector<Eigen::Vector3d>& way, const Eigen::Vector3d& spot, double radius_m)
{
	for (std::size_t i = 1; i < way.size(); ++i)
		for (int step = 0; step <= 100; ++step)
			if ((way[i - 1] + 0.01 * step * (way[i] - way[i - 1]) - spot).norm() < radius_m) return true;
	return false;
}

TEST(ShortenedWay, KeepsOffSpotsWhereTheRobotWasStopped)
{
	const Eigen::Vector3d from(0.925, 0.925, 0), to(4.925, 0.925, 0);
	const auto way = [&](const PlanMap& map)
	{ return shortenedWay(map, travelFrom(map, map.cellOf(from), {}, {}), map.cellOf(to), {}); };
	const std::vector<Eigen::Vector3d> open = way(planOf(kTwoRooms, from));
	ASSERT_GE(open.size(), 2U);
	const Eigen::Vector3d spot = 0.5 * (open[0] + open[1]);
	const std::vector<Eigen::Vector3d> blocked = way(planOf(kTwoRooms, from, {spot}));
	ASSERT_GE(blocked.size(), 2U);
	EXPECT_FALSE(passesNear(blocked, spot, 0.15));
	EXPECT_GT(lengthOf(blocked), lengthOf(open));
}

/** From a point to the middle of the nearest cell with something in it. */
double clearanceAt(const PlanMap& map, const Eigen::Vector3d& point)
{
	double nearest_m = 10.0;
	for (CellIndex cell = 0; cell < map.cells.size(); ++cell)
		if (map.cells[cell] == CellState::occupied)
			nearest_m = std::min(nearest_m, (map.middleOf(cell) - point).head<2>().norm());
	return nearest_m;
}

/** A room with posts. */
test::DrawnMap randomPosts(std::mt19937& random)
{
	std::vector<std::string> rows(70, std::string(70, '.'));
	for (int i = 0; i < 12; ++i) rows[random() % 70][random() % 70] = '#';
	for (std::size_t i = 0; i < 70; ++i) rows[0][i] = rows[69][i] = rows[i][0] = rows[i][69] = '#';
	return test::DrawnMap(rows);
}

TEST(ShortenedWay, IsShorterAndNoNearerToThingsThanWhatItReplaces)
{
	std::mt19937 random(31);
	int compared = 0;
	for (int trial = 0; trial < 15; ++trial)
	{
		SCOPED_TRACE(trial);
		const Eigen::Vector3d from(0.5, 0.5 + 0.05 * static_cast<double>(random() % 40), 0), to(2.9, 2.8, 0);
		const PlanMap map = planOf(randomPosts(random), from);
		const CellIndex start = map.cellOf(from), end = map.cellOf(to);
		const PlanConfig config;
		const TravelField field = travelFrom(map, start, {}, config);
		if (map.passable[start] == 0 || !field.reaches(end)) continue;
		++compared;
		std::vector<Eigen::Vector3d> long_way;
		for (const CellIndex cell : field.wayTo(end)) long_way.push_back(map.middleOf(cell));
		const std::vector<Eigen::Vector3d> way = shortenedWay(map, field, end, config);
		ASSERT_GE(way.size(), 2U);
		EXPECT_EQ(way.front(), long_way.front());
		EXPECT_EQ(way.back(), long_way.back());
		EXPECT_LE(lengthOf(way), lengthOf(long_way) + 1e-9);
		auto at = long_way.begin();
		for (std::size_t i = 1; i < way.size(); ++i)
		{
			const auto next = std::find(at, long_way.end(), way[i]);
			ASSERT_NE(next, long_way.end()) << "corners lie on the way, in its order";
			double replaced_m = config.comfort_m, kept_m = 10.0;
			for (auto cell = at; cell <= next; ++cell) replaced_m = std::min(replaced_m, clearanceAt(map, *cell));
			for (int step = 0; step <= 40; ++step)
				kept_m = std::min(kept_m, clearanceAt(map, way[i - 1] + step / 40.0 * (way[i] - way[i - 1])));
			EXPECT_GE(kept_m, replaced_m - kCell_m) << "leg " << i;
			at = next;
		}
	}
	EXPECT_GE(compared, 8) << "the test saw too little";
}

TEST(ShortenedWay, IsOneLineInTheOpenAndNothingWithoutAWay)
{
	const PlanMap map = planOf(kTwoRooms, kTwoRooms.at('a'));
	const TravelField field = travelFrom(map, map.cellOf(kTwoRooms.at('a')), {}, {});
	EXPECT_EQ(shortenedWay(map, field, map.cellOf({2.1, 0.8, 0}), {}).size(), 2U);
	EXPECT_EQ(shortenedWay(map, field, field.start, {}).size(), 1U);
	EXPECT_TRUE(shortenedWay(map, field, map.cellOf({0.1, 0.1, 0}), {}).empty());
}

TEST(LengthOf, AddsUpTheLegs)
{
	EXPECT_DOUBLE_EQ(lengthOf({{0, 0, 0}, {3, 4, 0}, {3, 4, 2}}), 7.0);
	EXPECT_EQ(lengthOf({{1, 1, 1}}), 0.0);
	EXPECT_EQ(lengthOf({}), 0.0);
}
}  // namespace
}  // namespace explore
