#include <explore/navigation/plan_map.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/drawn_map.h"
#include "support/random_points.h"

namespace explore
{
namespace
{
constexpr double kCell_m = 0.05;

PlanMap planOf(const test::DrawnMap& drawn, const Eigen::Vector3d& robot_in_map, const AllowedArea& area = {},
               const RobotConfig& robot = {}, const std::vector<Eigen::Vector3d>& blocked = {})
{
	const BodyLayers layers = test::layersOf(drawn, robot);
	return planMap({layers, area, robot_in_map, {}, blocked}, robot, {});
}

bool isObstacle(CellState state)
{
	return state == CellState::occupied || state == CellState::drop;
}

/** What a plan should be, each cell compared with every other near it. */
class SlowPlan
{
public:
	SlowPlan(const PlanMap& map, const AllowedArea& area, const Eigen::Vector3d& robot_in_map, double fit_m)
	    : m_map(map), m_area(area), m_fit_m(fit_m), m_reached(map.cells.size(), 0)
	{
		reachFrom(map.cellOf(robot_in_map));
	}

	[[nodiscard]] bool isPassable(CellIndex cell) const
	{
		const bool free = m_map.cells[cell] == CellState::free && m_area.allows(m_map.middleOf(cell).head<2>());
		return free && keeps(cell, 0.24) &&
		       nearest(cell, [&](CellIndex other) { return isEdge(other); }) >= m_fit_m + kCell_m - 1e-6;
	}
	[[nodiscard]] bool isWanted(CellIndex cell) const
	{
		return m_map.cells[cell] == CellState::unknown && m_reached[cell] != 0;
	}

private:
	template <class Is>
	[[nodiscard]] double nearest(CellIndex cell, const Is& is) const
	{
		double nearest_m = 100.0;
		const Eigen::Array3i place = m_map.placeOf(cell);
		for (int dy = -9; dy <= 9; ++dy)
			for (int dx = -9; dx <= 9; ++dx)
				if (const Eigen::Array3i other = place + Eigen::Array3i(dx, dy, 0);
				    m_map.contains(other) && is(m_map.cellAt(other)))
					nearest_m = std::min(nearest_m, kCell_m * std::hypot(dx, dy));
		return nearest_m;
	}
	[[nodiscard]] bool keeps(CellIndex cell, double away_m) const
	{
		return nearest(cell, [&](CellIndex other) { return isObstacle(m_map.cells[other]); }) >= away_m - 1e-6;
	}
	/** Unknown, and beside a free cell. */
	[[nodiscard]] bool isEdge(CellIndex cell) const
	{
		if (m_map.cells[cell] != CellState::unknown) return false;
		bool edge = false;
		forEachBeside(cell, [&](CellIndex other) { edge |= m_map.cells[other] == CellState::free; });
		return edge;
	}
	template <class Visit>
	void forEachBeside(CellIndex cell, const Visit& visit) const
	{
		const Eigen::Array3i place = m_map.placeOf(cell);
		for (const Eigen::Array3i& step :
		     {Eigen::Array3i(1, 0, 0), Eigen::Array3i(-1, 0, 0), Eigen::Array3i(0, 1, 0), Eigen::Array3i(0, -1, 0)})
			if (const Eigen::Array3i other = place + step; m_map.contains(other)) visit(m_map.cellAt(other));
	}
	/** Again and again over all cells, until nothing is added. */
	void reachFrom(CellIndex start)
	{
		m_reached[start] = 1;
		std::vector<std::uint8_t> open(m_map.cells.size());
		for (CellIndex cell = 0; cell < open.size(); ++cell)
			open[cell] = keeps(cell, m_fit_m) && m_area.allows(m_map.middleOf(cell).head<2>()) ? 1 : 0;
		for (bool more = true; more;)
		{
			more = false;
			for (CellIndex cell = 0; cell < open.size(); ++cell)
			{
				if (m_reached[cell] != 0 || open[cell] == 0) continue;
				bool joined = false;
				forEachBeside(cell, [&](CellIndex other) { joined |= m_reached[other] != 0; });
				m_reached[cell] = joined ? 1 : 0;
				more |= joined;
			}
		}
	}

	const PlanMap& m_map;
	const AllowedArea& m_area;
	double m_fit_m;
	std::vector<std::uint8_t> m_reached;
};

/** Blotches of everything on 3 m × 3 m, free where the robot stands. */
test::DrawnMap randomMap(std::mt19937& random)
{
	std::vector<std::string> rows(60, std::string(60, '?'));
	const auto blot = [&](char what, int largest)
	{
		const auto wide = 1 + static_cast<int>(random() % static_cast<unsigned>(largest));
		const auto high = 1 + static_cast<int>(random() % static_cast<unsigned>(largest));
		const auto x = static_cast<int>(random() % 60), y = static_cast<int>(random() % 60);
		for (int row = y; row < std::min(60, y + high); ++row)
			for (int column = x; column < std::min(60, x + wide); ++column)
				rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = what;
	};
	for (int i = 0; i < 12; ++i) blot('.', 40);
	for (int i = 0; i < 3; ++i) blot('?', 12);
	for (int i = 0; i < 6; ++i) blot(i % 3 == 0 ? 'v' : '#', 5);
	for (std::size_t row = 24; row < 36; ++row) std::fill_n(rows[row].begin() + 24, 12, '.');
	return test::DrawnMap(rows);
}

TEST(PlanMap, IsWhatASlowLookAtEveryCellSays)
{
	std::mt19937 random(5);
	std::size_t passable = 0, wanted = 0;
	for (int trial = 0; trial < 12; ++trial)
	{
		SCOPED_TRACE(trial);
		const test::DrawnMap drawn = randomMap(random);
		AllowedArea area;
		area.bounded = trial % 3 == 1;
		area.low = {0.3, 0.4};
		area.high = {2.6, 2.7};
		if (trial % 3 == 2) area.keep_out = {{{0.5, 0.5}, {1.2, 0.6}, {0.7, 1.1}}};
		const Eigen::Vector3d robot_in_map(1.51, 1.52, 0.0);
		const PlanMap map = planOf(drawn, robot_in_map, area);
		const SlowPlan slow(map, area, robot_in_map, 0.27);
		for (CellIndex cell = 0; cell < map.cells.size(); ++cell)
		{
			// What is drawn, and a metre of the unknown around it.
			if ((map.middleOf(cell).head<2>().array() - 1.5).abs().maxCoeff() > 2.5) continue;
			ASSERT_EQ(map.passable[cell] != 0, slow.isPassable(cell)) << map.middleOf(cell).transpose();
			ASSERT_EQ(map.wanted[cell] != 0, slow.isWanted(cell)) << map.middleOf(cell).transpose();
			passable += map.passable[cell];
			wanted += map.wanted[cell];
		}
	}
	EXPECT_GT(passable, 500U) << "the test saw too little";
	EXPECT_GT(wanted, 2000U) << "the test saw too little";
}

/** A room of 3 m × 2.4 m, known but for a corner; 0.2 m a character. The right wall has a gap of 0.2 m. */
const test::DrawnMap kRoom({"?????????????????",    //
                            "################?",    //
                            "#............???#",    //
                            "#............???#",    //
                            "#............???#",    //
                            "#...............#",    //
                            "#...r...........???",  //
                            "#...............#",    //
                            "#...............#",    //
                            "#...............#",    //
                            "################?",    //
                            "?????????????????"},
                           0.2);

CellIndex cellAt(const PlanMap& map, double x_m, double y_m)
{
	return map.cellOf({x_m, y_m, 0.0});
}

TEST(PlanMap, TheRobotKeepsItsDistanceFromWallsAndTheUnknown)
{
	const PlanMap map = planOf(kRoom, kRoom.at('r'));
	EXPECT_DOUBLE_EQ(map.fit_m, 0.27);
	// The left wall ends at x = 0.2: its last cells' middles are at 0.175.
	EXPECT_FALSE(map.passable[cellAt(map, 0.375, 1.125)]) << "0.20 m from the wall's middle";
	EXPECT_TRUE(map.passable[cellAt(map, 0.425, 1.125)]) << "0.25 m";
	// The unknown corner begins at x = 2.6, y = 1.4.
	EXPECT_FALSE(map.passable[cellAt(map, 2.325, 1.525)]) << "0.30 m from what is not known";
	EXPECT_TRUE(map.passable[cellAt(map, 2.275, 1.525)]) << "0.35 m";
}

TEST(PlanMap, WantedIsTheUnknownThatTheBodyMightGetTo)
{
	const PlanMap map = planOf(kRoom, kRoom.at('r'));
	EXPECT_TRUE(map.wanted[cellAt(map, 2.825, 1.625)]) << "the corner";
	EXPECT_FALSE(map.wanted[cellAt(map, 3.125, 2.125)]) << "too near to the walls to stand there";
	EXPECT_FALSE(map.wanted[cellAt(map, 3.325, 1.125)]) << "behind a gap that is too narrow";
	EXPECT_FALSE(map.wanted[cellAt(map, 0.5, 0.1)]) << "behind a wall";
	EXPECT_FALSE(map.wanted[cellAt(map, 1.0, 1.1)]) << "known";
	EXPECT_TRUE(map.near_wanted[cellAt(map, 2.575, 1.725)]) << "the last known cell before the corner";
	EXPECT_FALSE(map.near_wanted[cellAt(map, 2.525, 1.725)]);
}

TEST(PlanMap, WhatIsKeptOutIsNeitherPassableNorWanted)
{
	AllowedArea area;
	area.keep_out = {{{2.0, 0.0}, {3.4, 0.0}, {3.4, 2.4}, {2.0, 2.4}}};
	const PlanMap map = planOf(kRoom, kRoom.at('r'), area);
	EXPECT_TRUE(map.passable[cellAt(map, 1.975, 1.125)]) << "up to the line";
	EXPECT_FALSE(map.passable[cellAt(map, 2.025, 1.125)]);
	EXPECT_EQ(std::count(map.wanted.begin(), map.wanted.end(), 1), 0) << "the corner is beyond";
}

TEST(PlanMap, ARobotNearerToAThingThanItMayBeStillWantsWhatItCanGetTo)
{
	const test::DrawnMap drawn({"##################", "#................?", "#.r..............?", "#................?",
	                            "#................?", "#................?", "#................?", "##################"},
	                           0.1);
	const Eigen::Vector3d robot_in_map(0.225, drawn.at('r').y(), 0.0);  // 0.15 m from a wall where 0.27 m are asked for
	const PlanMap map = planOf(drawn, robot_in_map);
	EXPECT_GT(std::count(map.wanted.begin(), map.wanted.end(), 1), 0);
}

TEST(PlanMap, ADropIsAnObstacle)
{
	const test::DrawnMap drawn({"......vv......", "..r...vv......", "......vv......", "......vv......"}, 0.2);
	const PlanMap map = planOf(drawn, drawn.at('r'));
	EXPECT_EQ(map.cells[cellAt(map, 1.3, 0.5)], CellState::drop);
	EXPECT_FALSE(map.passable[cellAt(map, 1.025, 0.425)]);
	EXPECT_NEAR(map.obstacle_m[cellAt(map, 1.025, 0.425)], 0.2, 1e-6);
}

TEST(PlanMap, SpotsWhereTheRobotWasStoppedAreBlocked)
{
	const Eigen::Vector3d spot = kRoom.middleOf(9, 5);
	const PlanMap map = planOf(kRoom, kRoom.at('r'), {}, {}, {spot});
	EXPECT_TRUE(map.blocked[map.cellOf(spot)]);
	EXPECT_TRUE(map.blocked[map.cellOf(spot + Eigen::Vector3d(0.14, -0.14, 0))]);
	EXPECT_FALSE(map.blocked[map.cellOf(spot + Eigen::Vector3d(0.25, 0, 0))]);
	EXPECT_TRUE(map.passable[map.cellOf(spot)]);
	EXPECT_EQ(std::count(map.blocked.begin(), map.blocked.end(), 1), 49);
}

TEST(PlanMap, WhereItWasStoppedAgainAndAgainNoWayLeadsForNow)
{
	const test::DrawnMap hall(std::vector<std::string>(60, std::string(60, '.')));
	const Eigen::Vector3d robot(0.7, 0.7, 0), spot(1.5, 1.5, 0), near(1.7, 1.5, 0), far(1.5, 2.3, 0);
	const auto passes = [&](const std::vector<Eigen::Vector3d>& stops, const Eigen::Vector3d& at)
	{
		const PlanMap map = planOf(hall, robot, {}, {}, stops);
		return map.passable[map.cellOf(at)] != 0;
	};
	EXPECT_TRUE(passes({}, spot));
	EXPECT_TRUE(passes({spot, near}, spot)) << "twice: only dear";
	EXPECT_TRUE(passes({spot, near, far}, spot)) << "the third was elsewhere";
	EXPECT_FALSE(passes({spot, near, spot}, spot));
	EXPECT_FALSE(passes({spot, near, spot}, spot + Eigen::Vector3d(0.25, -0.25, 0)));
	EXPECT_TRUE(passes({spot, near, spot}, spot - Eigen::Vector3d(0.4, 0, 0)));
}

TEST(PlanMap, WhereTheRobotHasBeenItFitsAlthoughThingsSeemNearerSince)
{
	// A passage of 0.4 m in which each wall seems half a cell too near for a robot of 0.18 m and its margin.
	std::vector<std::string> rows(20, std::string(40, '.'));
	for (int row = 0; row < 20; ++row)
		if (row < 7 || row > 13) rows[static_cast<std::size_t>(row)].replace(15, 10, std::string(10, '#'));
	const test::DrawnMap drawn(rows);
	const Eigen::Vector3d within(1.025, 0.475, 0.0);
	const BodyLayers layers = test::layersOf(drawn);
	const AllowedArea everywhere;
	const PlanMap before = planMap({layers, everywhere, {0.5, 0.5, 0.0}, {}, {}}, {}, {});
	ASSERT_FALSE(before.passable[before.cellOf(within)]);
	const PlanMap after = planMap({layers, everywhere, {0.5, 0.5, 0.0}, {within}, {}}, {}, {});
	EXPECT_TRUE(after.passable[after.cellOf(within)]);
	EXPECT_FALSE(after.passable[after.cellOf(within + Eigen::Vector3d(0.15, 0, 0))]) << "it has not been there";
	const PlanMap wall = planMap({layers, everywhere, {0.5, 0.5, 0.0}, {{1.0, 0.1, 0.0}}, {}}, {}, {});
	EXPECT_FALSE(wall.passable[wall.cellOf({1.0, 0.1, 0.0})]) << "things may come after it";
}

TEST(PlanMap, WhatItMightReachIsAskedFromWhereverItHasBeen)
{
	// Two rooms, and between them a doorway that the robot squeezed through; the exit is in the room that it came from.
	std::vector<std::string> rows(40, std::string(40, '.') + std::string(8, '#') + std::string(40, '.') + "##");
	for (std::string& row : rows) row[0] = '?';
	rows.front() = rows.back() = std::string(90, '#');
	for (int row = 16; row < 24; ++row) rows[static_cast<std::size_t>(row)].replace(40, 8, "........");
	const test::DrawnMap drawn(rows);
	const BodyLayers layers = test::layersOf(drawn);
	const AllowedArea everywhere;
	const Eigen::Vector3d beyond(3.5, 1.0, 0.0), exit(0.025, 1.0, 0.0);
	const PlanMap stranger = planMap({layers, everywhere, beyond, {}, {}}, {}, {});
	ASSERT_FALSE(stranger.wanted[stranger.cellOf(exit)]) << "the doorway is too narrow to want what is behind it";
	const PlanMap traveller = planMap({layers, everywhere, beyond, {{1.0, 1.0, 0.0}, {2.2, 1.0, 0.0}}, {}}, {}, {});
	EXPECT_TRUE(traveller.wanted[traveller.cellOf(exit)]);
}

TEST(PlanMap, CellsAndPointsBelongTogether)
{
	RobotConfig mav;
	mav.kind = RobotKind::mav;
	mav.height_m = 0.25;
	const PlanMap map = planOf(kRoom, {1.0, 1.0, 1.0}, {}, mav);
	std::mt19937 random(6);
	for (int i = 0; i < 500; ++i)
	{
		const auto cell = static_cast<CellIndex>(random() % map.cells.size());
		ASSERT_EQ(map.cellAt(map.placeOf(cell)), cell);
		ASSERT_EQ(map.cellOf(map.middleOf(cell)), cell);
		const Eigen::Vector3d off(test::uniform(random, -0.02, 0.02), test::uniform(random, -0.02, 0.02),
		                          test::uniform(random, -0.1, 0.1));
		ASSERT_EQ(map.cellOf(map.middleOf(cell) + off), cell);
	}
	EXPECT_EQ(map.cellOf({-90.0, 1.0, 1.0}), kNoCell);
	EXPECT_EQ(map.cellOf({1.0, 1.0, 9.0}), map.cellOf({1.0, 1.0, 2.0})) << "the nearest layer";
}

TEST(StraightWay, IsFreeWhereEveryCellOnItIs)
{
	const PlanMap map = planOf(kRoom, kRoom.at('r'), {}, {}, {kRoom.middleOf(9, 7)});
	const CellIndex from = cellAt(map, 0.625, 0.725);
	EXPECT_TRUE(straightWayIsFree(map, from, cellAt(map, 2.625, 0.825), 0.0));
	EXPECT_TRUE(straightWayIsFree(map, from, from, 0.0));
	EXPECT_FALSE(straightWayIsFree(map, from, cellAt(map, 2.825, 1.625), 0.0)) << "through the unknown corner";
	EXPECT_FALSE(straightWayIsFree(map, from, cellAt(map, 2.625, 0.825), 0.6)) << "it passes a wall nearer than that";
	EXPECT_FALSE(straightWayIsFree(map, cellAt(map, 1.025, 1.525), cellAt(map, 2.225, 1.525), 0.0))
	    << "through a spot where the robot was stopped";
}
}  // namespace
}  // namespace explore
