// The reachable space of hand-made worlds, whose answer is known, and of random ones against contact tests cell by
// cell.
#include <explore/simulation/load_world.h>
#include <explore/simulation/plan_triangle.h>
#include <explore/simulation/random.h>
#include <explore/simulation/ray_scene.h>
#include <explore/simulation/reachable_space.h>
#include <explore/simulation/robot_body.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <deque>
#include <set>

#include "box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;

namespace
{
using Cell = std::array<int, 3>;  ///< column and row as in TruthReach, level

/** Walls of 10 cm around x 0 … `length_m`, y 0 … `width_m`, and a floor beneath. */
World room(double length_m, double width_m, double wall_height_m = 2.5)
{
	World world;
	addBox(world, {{-1, -1, -0.1}, {length_m + 1, width_m + 1, 0.0}}, "floor");
	addBox(world, {{-0.1, -0.1, 0.0}, {0.0, width_m + 0.1, wall_height_m}});
	addBox(world, {{length_m, -0.1, 0.0}, {length_m + 0.1, width_m + 0.1, wall_height_m}});
	addBox(world, {{0.0, -0.1, 0.0}, {length_m, 0.0, wall_height_m}});
	addBox(world, {{0.0, width_m, 0.0}, {length_m, width_m + 0.1, wall_height_m}});
	return world;
}

/** A wall across a room of 6 m × 4 m at x = 3, with a gap around y = 2. */
World twoRooms(double gap_m)
{
	World world = room(6, 4);
	addBox(world, {{2.95, 0.0, 0.0}, {3.05, 2.0 - 0.5 * gap_m, 2.5}});
	addBox(world, {{2.95, 2.0 + 0.5 * gap_m, 0.0}, {3.05, 4.0, 2.5}});
	return world;
}

bool reaches(const TruthReach& reach, double x, double y, std::size_t level = 0)
{
	const int column = static_cast<int>(std::floor(x / reach.cell_m)) - reach.first_column;
	const int row = static_cast<int>(std::floor(y / reach.cell_m)) - reach.first_row;
	if (column < 0 || column >= reach.columns || row < 0 || row >= reach.rows) return false;
	return reach.levels.at(level).reachable.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(reach.columns) +
	                                           static_cast<std::size_t>(column)) != 0;
}

std::set<Cell> cellsOf(const TruthReach& reach)
{
	std::set<Cell> cells;
	for (std::size_t level = 0; level < reach.levels.size(); ++level)
		for (int row = 0; row < reach.rows; ++row)
			for (int column = 0; column < reach.columns; ++column)
				if (reach.levels[level]
				        .reachable[static_cast<std::size_t>(row) * static_cast<std::size_t>(reach.columns) +
				                   static_cast<std::size_t>(column)] != 0)
					cells.insert({column, row, static_cast<int>(level)});
	return cells;
}

/** The same by a contact test of each cell that the flood comes to. */
std::set<Cell> slowly(const TruthReach& grid, const RayScene& scene, const RobotConfig& robot, const Cell& start)
{
	const auto fits = [&](const Cell& cell)
	{
		const bool inside = cell[0] >= 0 && cell[0] < grid.columns && cell[1] >= 0 && cell[1] < grid.rows &&
		                    cell[2] >= 0 && cell[2] < static_cast<int>(grid.levels.size());
		if (!inside) return false;
		const Vector2d middle = grid.centerOf(cell[0], cell[1]);
		const TruthReach::Level& level = grid.levels[static_cast<std::size_t>(cell[2])];
		if (robot.kind == RobotKind::ground)
			return !scene.touchesCylinder({middle.x(), middle.y(), kUnderbody_m}, robot.radius_m + 0.05,
			                              robot.height_m - kUnderbody_m);
		const double low_z = 0.5 * (level.low_m + level.high_m) - 0.5 * robot.height_m - 0.05;
		return !scene.touchesCylinder({middle.x(), middle.y(), low_z}, robot.radius_m + 0.05, robot.height_m + 0.1);
	};
	std::set<Cell> reached;
	std::deque<Cell> open{start};
	if (fits(start)) reached.insert(start);
	while (!open.empty())
	{
		const Cell at = open.front();
		open.pop_front();
		for (std::size_t axis = 0; axis < 3; ++axis)
			for (const int step : {-1, 1})
			{
				Cell next = at;
				next[axis] += step;
				if (!reached.contains(next) && fits(next)) reached.insert(next), open.push_back(next);
			}
	}
	return reached;
}

Vector3d anywhere(Random& random, double reach_m)
{
	return {random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m), random.uniform(-reach_m, reach_m)};
}
}  // namespace

TEST(PlanTriangle, AgreesWithTheContactTestOfCylinders)
{
	Random random(3);
	int met = 0;
	for (int i = 0; i < 20000; ++i)
	{
		Triangle triangle{anywhere(random, 1.0), anywhere(random, 1.0), anywhere(random, 1.0)};
		if (i % 5 == 0) triangle[1].z() = triangle[2].z() = triangle[0].z();                                // level
		if (i % 5 == 1) triangle[2].head<2>() = 0.3 * triangle[0].head<2>() + 0.7 * triangle[1].head<2>();  // upright
		const VerticalCylinder cylinder{anywhere(random, 1.0), random.uniform(0.01, 0.8), random.uniform(0.01, 0.6)};
		const auto heights = PlanTriangle(triangle).within(cylinder.base.head<2>(), cylinder.radius_m);
		const bool meeting =
		    heights && heights->low_m <= cylinder.base.z() + cylinder.height_m && heights->high_m >= cylinder.base.z();
		EXPECT_EQ(meeting, meets(cylinder, triangle)) << i;
		met += meeting ? 1 : 0;
	}
	EXPECT_GT(met, 2000);
}

TEST(ReachableSpace, AnEmptyRoomButForItsMargins)
{
	const TruthReach reach = reachableSpace(room(4, 3), {}, {1, 1, 0});
	ASSERT_EQ(reach.levels.size(), 1U);
	EXPECT_EQ(reach.levels[0].low_m, 0.10);
	EXPECT_EQ(reach.levels[0].high_m, 0.60);
	// Middles from 0.275 to 3.725 and to 2.725: 70 columns, 50 rows.
	EXPECT_EQ(reach.cells(), 70U * 50U);
	EXPECT_NEAR(reach.floorArea(), 70 * 50 * 0.0025, 1e-9);
	EXPECT_TRUE(reaches(reach, 0.28, 0.28));
	EXPECT_FALSE(reaches(reach, 0.22, 1.0));
}

TEST(ReachableSpace, AGapIsPassableWhereTheRobotFitsWithItsMargins)
{
	EXPECT_TRUE(reaches(reachableSpace(twoRooms(0.60), {}, {1, 1, 0}), 5, 2));
	EXPECT_FALSE(reaches(reachableSpace(twoRooms(0.50), {}, {1, 1, 0}), 5, 2));
}

TEST(ReachableSpace, WhoWalksIsNotInTheWay)
{
	World world = twoRooms(0.9);
	MovingBody person;
	person.mesh = personMesh(1.75, 0.25);
	person.material = world.materialNamed("person");
	person.track = {{0.0, {3.0, 2.0}}};
	world.moving.push_back(person);
	EXPECT_TRUE(reaches(reachableSpace(world, {}, {1, 1, 0}), 5, 2));
}

TEST(ReachableSpace, BoundsEndIt)
{
	const Eigen::AlignedBox2d bounds(Vector2d(0.5, 0.5), Vector2d(2.0, 2.5));
	const TruthReach reach = reachableSpace(room(4, 3), {}, {1, 1, 0}, bounds);
	EXPECT_EQ(reach.cells(), 30U * 40U);
}

TEST(ReachableSpace, UnderATableButNotOntoIt)
{
	World world = room(4, 3);
	addBox(world, {{1.5, 1.0, 0.70}, {2.5, 2.0, 0.75}}, "table");
	EXPECT_TRUE(reaches(reachableSpace(world, {}, {0.5, 0.5, 0}), 2.0, 1.5));
	RobotConfig taller;
	taller.height_m = 0.72;
	EXPECT_FALSE(reaches(reachableSpace(world, taller, {0.5, 0.5, 0}), 2.0, 1.5));
}

TEST(ReachableSpace, AHoleInTheFloorKeepsTheRobotOut)
{
	World world;
	addBox(world, {{0, 0, -0.1}, {3.0, 3, 0.0}}, "floor");
	addBox(world, {{4.0, 0, -0.1}, {7, 3, 0.0}}, "floor");
	addBox(world, {{3.0, 1.0, -0.1}, {4.0, 1.3, 0.0}}, "plank");
	addBox(world, {{-0.1, 3.0, 0.0}, {7.1, 3.1, 2.0}});
	addBox(world, {{-0.1, -0.1, 0.0}, {7.1, 0.0, 2.0}});
	EXPECT_FALSE(reaches(reachableSpace(world, {}, {1, 1, 0}), 5, 1.15)) << "over a plank narrower than itself";
	addBox(world, {{3.0, 0.7, -0.1}, {4.0, 1.6, 0.0}}, "bridge");
	EXPECT_TRUE(reaches(reachableSpace(world, {}, {1, 1, 0}), 5, 1.15));
}

TEST(ReachableSpace, AMavFliesOverALowWall)
{
	World world = room(6, 4);
	addBox(world, {{2.95, 0.0, 0.0}, {3.05, 4.0, 1.0}}, "low wall");
	EXPECT_FALSE(reaches(reachableSpace(world, {}, {1, 2, 0}), 5, 2));
	const TruthReach reach = reachableSpace(world, mav(), {1, 2, 1.25});
	ASSERT_EQ(reach.levels.size(), 30U);
	EXPECT_NEAR(reach.levels.front().low_m, 0.5, 1e-9);
	EXPECT_NEAR(reach.levels.back().high_m, 2.0, 1e-9);
	EXPECT_TRUE(reaches(reach, 5, 2, 0));
	// Over the wall: half of the body and the margin above it.
	for (std::size_t i = 0; i < reach.levels.size(); ++i)
	{
		const double middle_m = 0.5 * (reach.levels[i].low_m + reach.levels[i].high_m);
		if (std::abs(middle_m - 1.175) < 0.001) continue;  // just touches
		EXPECT_EQ(reaches(reach, 3.0, 2.0, i), middle_m > 1.175) << middle_m;
	}
}

TEST(ReachableSpace, AStartInATightCellGoesOnFromTheNearestOne)
{
	EXPECT_EQ(reachableSpace(room(4, 3), {}, {0.24, 1, 0}).cells(), 70U * 50U);
	EXPECT_EQ(reachableSpace(room(4, 3), {}, {-0.05, 1, 0}).cells(), 0U);
}

TEST(ReachableSpace, AgreesWithContactTestsInRandomRooms)
{
	Random random(11);
	for (int i = 0; i < 12; ++i)
	{
		World world = room(5, 4);
		for (int box = 0; box < 10; ++box)
		{
			const Vector3d low(random.uniform(0.3, 4.6), random.uniform(0.3, 3.6),
			                   random.chance(0.5) ? 0.0 : random.uniform(0.0, 1.8));
			addBox(world, {low, low + Vector3d(random.uniform(0.05, 0.9), random.uniform(0.05, 0.9),
			                                   random.uniform(0.05, 1.0))});
		}
		const RobotConfig robot = i % 3 == 2 ? mav() : RobotConfig{};
		const Vector3d start(0.6, 0.6, robot.kind == RobotKind::mav ? 1.25 : 0.0);
		const TruthReach reach = reachableSpace(world, robot, start);
		const std::set<Cell> cells = cellsOf(reach);
		if (cells.empty()) continue;
		const RayScene scene(world);
		EXPECT_EQ(cells, slowly(reach, scene, robot, *cells.begin())) << i;
	}
}

TEST(ReachableSpace, TheOfficesRoomsBehindOpenDoorsOnly)
{
	const World world = loadWorld(std::filesystem::path(EXPLORE_SOURCE_DIR) / "rawlogs/worlds/office.sdf", {});
	const TruthReach reach = reachableSpace(world, {}, world.spawns.front().position_in_map);
	for (const Spawn& spawn : world.spawns)
		EXPECT_TRUE(reaches(reach, spawn.position_in_map.x(), spawn.position_in_map.y())) << spawn.name;
	for (const DoorLabel& door : world.doors)
	{
		const bool wide = door.clear_width_m > 2 * (0.22 + 0.05) + 0.05;
		const bool shut = door.verdict == Verdict::closed || door.verdict == Verdict::blocked;
		const bool open = door.verdict == Verdict::open && wide && door.sill_m <= 0.0;
		if (!shut && !open) continue;
		EXPECT_EQ(reaches(reach, door.floor_center_in_map.x(), door.floor_center_in_map.y()), open) << door.id;
	}
}
