// The corridor and the obstacles that a camera truly sees.
#include <explore/simulation/truth_rays.h>

#include <gmock/gmock.h>

#include <cmath>

#include "box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using mrpt::poses::CPose3D;

namespace
{
/** Two walls along x from 0 on, their faces `width_m` apart. */
World corridorOf(double length_m, double width_m)
{
	World world;
	const double side = 0.5 * width_m;
	addBox(world, {{0.0, side, 0.0}, {length_m, side + 0.1, 2.5}});
	addBox(world, {{0.0, -side - 0.1, 0.0}, {length_m, -side, 2.5}});
	world.corridors.push_back({"corridor", {0.0, 0.0}, {length_m, 0.0}, width_m});
	return world;
}

TruthFrame lookAt(const World& world, const CPose3D& map_from_robot = {})
{
	const RayScene scene(world);
	return truthAt(scene, wideCamera(), {}, map_from_robot);
}
}  // namespace

TEST(TruthCorridor, NeedsThreeWidthsOfBothWallsInView)
{
	// The image is 90° wide: walls 1 m to the sides come into view 1 m ahead.
	const TruthCorridor corridor = lookAt(corridorOf(7.2, 2.0)).corridor;
	EXPECT_EQ(corridor.state, CorridorState::corridor);
	EXPECT_NEAR(std::abs(corridor.direction_in_map.x()), 1.0, 1e-9);
	EXPECT_DOUBLE_EQ(corridor.width_m, 2.0);
	EXPECT_EQ(lookAt(corridorOf(6.7, 2.0)).corridor.state, CorridorState::not_scored);
	EXPECT_EQ(lookAt(corridorOf(3.8, 2.0)).corridor.state, CorridorState::not_scored);
	EXPECT_EQ(lookAt(corridorOf(3.3, 2.0)).corridor.state, CorridorState::none);
}

TEST(TruthCorridor, IsOneWhereWallsFaceAtHumanWidths)
{
	EXPECT_EQ(lookAt(corridorOf(30.0, 4.5)).corridor.state, CorridorState::none);
	EXPECT_EQ(lookAt(corridorOf(30.0, 0.7)).corridor.state, CorridorState::none);
	EXPECT_EQ(lookAt(corridorOf(30.0, 3.9)).corridor.state, CorridorState::corridor);
}

TEST(TruthCorridor, NeedsBothWallsInView)
{
	EXPECT_EQ(lookAt(corridorOf(10.0, 2.0), {5, 0, 0, M_PI / 2, 0, 0}).corridor.state, CorridorState::none);
	EXPECT_EQ(lookAt(corridorOf(10.0, 2.0), {10, 0, 0, 0, 0, 0}).corridor.state, CorridorState::none);
	EXPECT_EQ(lookAt(corridorOf(10.0, 2.0), {10, 0, 0, M_PI, 0, 0}).corridor.state, CorridorState::corridor);
	World crossed = corridorOf(10.0, 2.0);
	addBox(crossed, {{2.0, -1.0, 0.0}, {2.1, 1.0, 2.5}});
	EXPECT_EQ(lookAt(crossed).corridor.state, CorridorState::none);
}

TEST(TruthCorridor, EndsWhereTheWallsDo)
{
	World world = corridorOf(5.0, 2.0);
	world.corridors.front().end_in_map.x() = 10.0;  // a label that says too much
	EXPECT_EQ(lookAt(world).corridor.state, CorridorState::not_scored);
}

TEST(TruthCorridor, APillarDoesNotEndIt)
{
	World world = corridorOf(10.0, 2.0);
	addBox(world, {{3.0, 0.6, 0.0}, {3.3, 1.0, 2.5}});
	EXPECT_EQ(lookAt(world).corridor.state, CorridorState::corridor);
}

TEST(TruthObstacles, AreThoseOfWhichAPartIsInView)
{
	World world = corridorOf(10.0, 3.0);
	addBox(world, {{2.9, -0.1, 0.0}, {3.1, 0.1, 1.0}}, "box");
	world.obstacles.push_back({"box", {3.0, 0.0, 0.0}, 0.15, 1.0});
	world.obstacles.push_back({"behind the wall", {3.0, 3.0, 0.0}, 0.15, 1.0});
	world.obstacles.push_back({"behind the camera", {-2.0, 0.0, 0.0}, 0.15, 1.0});
	MovingBody person;
	person.kind = "person";
	person.mesh = personMesh();
	person.material = world.materialNamed("person");
	person.track = {{0.0, {5.0, 0.8}, 0.0, 0.0}};
	world.moving.push_back(person);

	const TruthFrame frame = lookAt(world);
	ASSERT_EQ(frame.obstacles.size(), 2U);
	EXPECT_EQ(frame.obstacles[0].kind, "box");
	EXPECT_LT((frame.obstacles[0].center_in_map - Vector3d(3.0, 0.0, 0.5)).norm(), 1e-9);
	EXPECT_EQ(frame.obstacles[1].kind, "person");
	EXPECT_LT((frame.obstacles[1].center_in_map - Vector3d(5.0, 0.8, 0.875)).norm(), 1e-9);
}
