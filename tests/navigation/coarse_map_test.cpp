#include <explore/navigation/coarse_map.h>
#include <explore/navigation/travel_field.h>
#include <gtest/gtest.h>

#include <random>

#include "support/drawn_map.h"

namespace explore
{
namespace
{
/** A floor of 9 m × 6 m with walls of one cell, some with gaps that the robot fits through and some with narrower ones.
 */
test::DrawnMap randomFloor(std::mt19937& random)
{
	constexpr int kColumns = 180, kRows = 120;
	std::vector<std::string> rows(kRows, std::string(kColumns, '.'));
	for (std::string& row : rows) row.front() = row.back() = '#';
	rows.front() = rows.back() = std::string(kColumns, '#');
	const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
	for (int wall = 0; wall < 5; ++wall)
	{
		const bool upright = below(2) == 0;
		const int at = 20 + below((upright ? kColumns : kRows) - 40);
		const int gap = below((upright ? kRows : kColumns) - 20), wide = below(20);
		for (int i = 0; i < (upright ? kRows : kColumns); ++i)
			if (i < gap || i >= gap + wide)
				(upright ? rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(at)]
				         : rows[static_cast<std::size_t>(at)][static_cast<std::size_t>(i)]) = '#';
	}
	return test::DrawnMap(rows);
}

TEST(CoarseMap, LeadsWhereTheFineOneDoesForAboutAsMuch)
{
	std::mt19937 random(5);
	const RobotConfig robot;
	const PlanConfig config;
	int ways = 0, none = 0;
	for (int trial = 0; trial < 25; ++trial)
	{
		SCOPED_TRACE(trial);
		const BodyLayers layers = test::layersOf(randomFloor(random));
		const PlanMap map = planMap({layers, {}, {1, 1, 0}, {}, {}}, robot, config);
		const int factor = coarseness(map, robot, config);
		const PlanMap coarse = coarsened(map, factor);
		std::vector<CellIndex> places;
		while (places.size() < 12)
			if (const auto cell = static_cast<CellIndex>(random() % map.cells.size()); map.passable[cell] != 0)
				places.push_back(cell);
		for (const CellIndex from : places)
		{
			const TravelField fine = travelFrom(map, from, robot, config);
			const TravelField rough = travelFrom(coarse, squareOf(map, coarse, from, factor), robot, config);
			for (const CellIndex to : places)
			{
				const CellIndex square = squareOf(map, coarse, to, factor);
				ASSERT_EQ(rough.reaches(square), fine.reaches(to));
				if (!fine.reaches(to) && ++none > 0) continue;
				++ways;
				EXPECT_LE(rough.costTo(square), 1.1 * fine.costTo(to) + 0.5);
				EXPECT_GE(rough.costTo(square), 0.6 * fine.costTo(to) - 0.5);
			}
		}
	}
	EXPECT_GT(ways, 500);
	EXPECT_GT(none, 100) << "or nothing says that a gap which is too narrow stays one";
}

TEST(CoarseMap, OfASmallRobotHasFinerCells)
{
	PlanMap map;
	RobotConfig robot;
	EXPECT_EQ(coarseness(map, robot, {}), 3) << "0.48 m across, cells of 0.05 m";
	robot.radius_m = 0.05;
	EXPECT_EQ(coarseness(map, robot, {}), 1);
	robot.radius_m = 0.02;
	EXPECT_EQ(coarseness(map, robot, {}), 1);
}

TEST(CoarseMap, ASquareIsBlockedWhereTheRobotWasStoppedInAllOfIt)
{
	const test::DrawnMap floor(std::vector<std::string>(40, std::string(40, '.')));
	const BodyLayers layers = test::layersOf(floor);
	PlanMap map = planMap({layers, {}, {1, 1, 0}, {}, {}}, {}, {});
	const CellIndex stopped = map.cellOf({1.0, 1.0, 0});
	ASSERT_NE(map.passable[stopped], 0);
	constexpr int kFactor = 2;
	const auto coarse = coarsened(map, kFactor);
	const CellIndex square = squareOf(map, coarse, stopped, kFactor);
	map.blocked[stopped] = 1;
	EXPECT_EQ(coarsened(map, kFactor).blocked[square], 0);
	for (CellIndex cell = 0; cell < map.cells.size(); ++cell)
		if (squareOf(map, coarse, cell, kFactor) == square) map.blocked[cell] = 1;
	EXPECT_EQ(coarsened(map, kFactor).blocked[square], 1);
	EXPECT_EQ(squareOf(map, coarsened(map, kFactor), kNoCell, kFactor), kNoCell);
}
}  // namespace
}  // namespace explore
