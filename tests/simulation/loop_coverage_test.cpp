// A simulated robot's frames become a map, and the map's coverage of what is reachable grows as it should.
#include <explore/evaluation/coverage.h>
#include <explore/memory/occupancy.h>
#include <explore/simulation/closed_loop.h>
#include <explore/simulation/reachable_space.h>

#include <gtest/gtest.h>

#include <cmath>

#include "box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;

namespace
{
/** Two rooms of 3 m × 3 m, x −1.5 … 1.5 and 1.6 … 4.6, and a door of 1 m between them. */
World twoRooms()
{
	World world;
	addBox(world, {{-2, -2, -0.1}, {5, 2, 0.0}}, "floor");
	addBox(world, {{-1.6, -1.6, 0.0}, {-1.5, 1.6, 2.5}});
	addBox(world, {{4.6, -1.6, 0.0}, {4.7, 1.6, 2.5}});
	addBox(world, {{-1.5, 1.5, 0.0}, {4.6, 1.6, 2.5}});
	addBox(world, {{-1.5, -1.6, 0.0}, {4.6, -1.5, 2.5}});
	addBox(world, {{1.5, 0.5, 0.0}, {1.6, 1.5, 2.5}});
	addBox(world, {{1.5, -1.5, 0.0}, {1.6, -0.5, 2.5}});
	return world;
}

/** Frames go into the map, the robot does as told. */
void drive(ClosedLoop& loop, Occupancy& map, double seconds, const Command& command)
{
	for (int i = 0; i < std::lround(seconds * 10); ++i)
	{
		map.insert(loop.next());
		loop.obey(command);
	}
}
}  // namespace

TEST(LoopCoverage, GrowsWithWhatTheRobotSees)
{
	const World world = twoRooms();
	RayScene scene(world);
	ClosedLoopConfig config;
	config.recorder.camera = depthCamera("xtion", 160);
	config.recorder.robot_from_camera = usualMount(RobotKind::ground);
	ClosedLoop loop(scene, config);
	Occupancy map{OccupancyConfig{}};
	const TruthReach reach = reachableSpace(world, {}, {0, 0, 0});
	const auto coverage = [&] { return evaluation::coverageOf(reach, map.tree()).share(); };
	EXPECT_EQ(coverage(), 0.0);

	const Command turn{Vector3d::Zero(), 1.0}, go{{0.4, 0, 0}, 0.0}, stay;
	drive(loop, map, 2 * M_PI + 0.5, turn);
	const double after_turn = coverage();
	// The robot's room, but for what is under its camera's view, and a wedge of the other through the door.
	EXPECT_GT(after_turn, 0.6);
	EXPECT_LT(after_turn, 0.95);

	drive(loop, map, 0.5, stay);
	const double yaw_rad = loop.robot().trueState().yaw_rad;
	drive(loop, map, std::remainder(-yaw_rad, 2 * M_PI) > 0 ? std::remainder(-yaw_rad, 2 * M_PI) : 0.0, turn);
	drive(loop, map, std::abs(std::min(0.0, std::remainder(-yaw_rad, 2 * M_PI))), {Vector3d::Zero(), -1.0});
	drive(loop, map, 8.0, go);
	drive(loop, map, 0.5, stay);
	drive(loop, map, 2 * M_PI + 0.5, turn);
	EXPECT_TRUE(loop.robot().contacts().empty());
	EXPECT_GT(coverage(), 0.98);
}
