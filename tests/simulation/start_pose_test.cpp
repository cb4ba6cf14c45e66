// Where a robot begins: spawns by name, places by numbers, and what is taken when nothing is said.
#include <explore/core/errors.h>
#include <explore/simulation/start_pose.h>

#include <gmock/gmock.h>

#include <cmath>

#include "box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using testing::HasSubstr;

namespace
{
World withSpawns()
{
	World world;
	world.spawns = {{"air", {9.0, 2.0, 1.2}, 0.5}, {"door", {1.0, 2.0, 0.0}, 1.0}, {"lobby", {3.0, 4.0, 0.0}, -1.0}};
	return world;
}

void expectPose(const mrpt::poses::CPose3D& pose, double x, double y, double z, double yaw_rad)
{
	EXPECT_NEAR(pose.x(), x, 1e-12);
	EXPECT_NEAR(pose.y(), y, 1e-12);
	EXPECT_NEAR(pose.z(), z, 1e-6);
	EXPECT_NEAR(pose.yaw(), yaw_rad, 1e-12);
}
}  // namespace

TEST(StartPose, NothingSaidIsTheFirstSpawnThatSuits)
{
	expectPose(startPose(withSpawns(), "", {}), 1.0, 2.0, 0.0, 1.0);
	expectPose(startPose(withSpawns(), "", mav()), 9.0, 2.0, 1.2, 0.5);
	expectPose(startPose({}, "", {}), 0.0, 0.0, 0.0, 0.0);
}

TEST(StartPose, ByNameOrByNumbers)
{
	expectPose(startPose(withSpawns(), "lobby", {}), 3.0, 4.0, 0.0, -1.0);
	expectPose(startPose(withSpawns(), "-1.5 1.2 90", {}), -1.5, 1.2, 0.0, M_PI / 2);
	expectPose(startPose(withSpawns(), "1 2 0.1 -90", {}), 1.0, 2.0, 0.1, -M_PI / 2);
}

TEST(StartPose, WithoutAHeightItIsOnTheFloorThere)
{
	World world;
	addBox(world, {{-5, -5, -0.1}, {5, 5, 0.07}}, "floor");
	addBox(world, {{1, 1, 0.6}, {3, 3, 0.7}}, "table");
	expectPose(startPose(world, "2 2 0", {}), 2.0, 2.0, 0.07F, 0.0);
	expectPose(startPose(world, "", {}), 0.0, 0.0, 0.07F, 0.0);
	expectPose(startPose(world, "2 2 0.1 0", {}), 2.0, 2.0, 0.1, 0.0);
	expectPose(startPose(world, "2 2 0", mav()), 2.0, 2.0, 0.07F + 1.25, 0.0);
}

TEST(StartPose, AMavStartsInItsBand)
{
	expectPose(startPose(withSpawns(), "lobby", mav()), 3.0, 4.0, 1.25, -1.0);
	expectPose(startPose(withSpawns(), "1 2 1.7 0", mav()), 1.0, 2.0, 1.7, 0.0);
}

TEST(StartPose, AMissListsTheSpawns)
{
	for (const char* start : {"kitchen", "1 2", "1 2 3 4 5", "1 2 east"}) try
		{
			startPose(withSpawns(), start, {});
			FAIL() << start;
		}
		catch (const ConfigError& error)
		{
			EXPECT_THAT(error.what(), AllOf(HasSubstr(start), HasSubstr("air, door, lobby")));
		}
}
