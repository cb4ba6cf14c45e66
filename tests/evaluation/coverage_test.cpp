// Coverage of maps that are written by hand.
#include <explore/evaluation/coverage.h>

#include <gtest/gtest.h>

#include <octomap/OcTree.h>

using namespace explore;
using namespace explore::evaluation;

namespace
{
/** 4 × 2 cells from (1.0, −0.5) on, all reachable but the last. */
TruthReach eightCells(double low_m = 0.10, double high_m = 0.60)
{
	TruthReach reach;
	reach.first_column = 20;
	reach.first_row = -10;
	reach.columns = 4;
	reach.rows = 2;
	reach.levels.push_back({low_m, high_m, {1, 1, 1, 1, 1, 1, 1, 0}});
	return reach;
}

void mark(octomap::OcTree& map, const TruthReach& reach, int column, int row, double z_m, bool occupied)
{
	const Eigen::Vector2d middle = reach.centerOf(column, row);
	map.updateNode(
	    octomap::point3d(static_cast<float>(middle.x()), static_cast<float>(middle.y()), static_cast<float>(z_m)),
	    occupied);
}
}  // namespace

TEST(TruthReach, CellsAndAreaOfItsLevels)
{
	TruthReach reach = eightCells();
	EXPECT_EQ(reach.cells(), 7U);
	EXPECT_NEAR(reach.floorArea(), 7 * 0.0025, 1e-12);
	reach.levels.push_back(reach.levels.front());
	reach.levels.back().reachable.back() = 1;
	EXPECT_EQ(reach.cells(), 15U);
	EXPECT_NEAR(reach.floorArea(), 8 * 0.0025, 1e-12);
}

TEST(Coverage, NothingReachableIsCovered)
{
	const octomap::OcTree map(0.05);
	EXPECT_EQ(coverageOf({}, map).share(), 1.0);
	EXPECT_EQ(coverageOf(eightCells(), map).share(), 0.0);
	EXPECT_EQ(coverageOf(eightCells(), map).reachable, 7U);
}

TEST(Coverage, OneFreeVoxelAndNoneOccupiedBetweenTheHeights)
{
	const TruthReach reach = eightCells();
	octomap::OcTree map(0.05);
	mark(map, reach, 0, 0, 0.32, false);
	EXPECT_EQ(coverageOf(reach, map).covered, 1U);
	mark(map, reach, 1, 0, 0.07, false);  // below
	mark(map, reach, 2, 0, 0.62, false);  // above
	EXPECT_EQ(coverageOf(reach, map).covered, 1U);
	mark(map, reach, 1, 0, 0.12, false);
	mark(map, reach, 1, 0, 0.02, true);  // the floor
	mark(map, reach, 2, 0, 0.57, false);
	mark(map, reach, 2, 0, 0.67, true);  // a lamp
	EXPECT_EQ(coverageOf(reach, map).covered, 3U);
	mark(map, reach, 0, 0, 0.57, true);
	EXPECT_EQ(coverageOf(reach, map).covered, 2U);
	mark(map, reach, 3, 1, 0.32, false);  // not reachable
	EXPECT_EQ(coverageOf(reach, map).covered, 2U);
	EXPECT_NEAR(coverageOf(reach, map).share(), 2.0 / 7.0, 1e-12);
}

TEST(Coverage, OfAFlightLevelTheVoxelItself)
{
	const TruthReach reach = eightCells(0.50, 0.55);
	octomap::OcTree map(0.05);
	mark(map, reach, 0, 0, 0.52, false);
	mark(map, reach, 0, 0, 0.57, true);
	mark(map, reach, 1, 0, 0.47, false);
	EXPECT_EQ(coverageOf(reach, map).covered, 1U);
}

TEST(Coverage, OfACoarserMapTheVoxelAboveTheMiddle)
{
	const TruthReach reach = eightCells();
	octomap::OcTree map(0.1);
	map.updateNode(octomap::point3d(1.05F, -0.45F, 0.35F), false);
	EXPECT_EQ(coverageOf(reach, map).covered, 4U);
}
