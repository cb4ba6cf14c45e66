// The simulated robot among things and people: contacts, and movers that wait for it.
#include <explore/core/errors.h>
#include <explore/simulation/random.h>
#include <explore/simulation/simulated_robot.h>

#include <gmock/gmock.h>

#include <cmath>

#include "box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using mrpt::poses::CPose3D;

namespace
{
Command forward(double speed_mps, double yaw_rate_radps = 0)
{
	return {{speed_mps, 0, 0}, yaw_rate_radps};
}

void run(SimulatedRobot& robot, const Command& command, double seconds, double dt_s = 0.05)
{
	for (int i = 0; i < std::lround(seconds / dt_s); ++i) robot.advance(command, dt_s);
}

World wallAt(double x, double thickness_m = 0.1)
{
	World world;
	addBox(world, {{x, -5.0, 0.0}, {x + thickness_m, 5.0, 2.0}});
	return world;
}

MovingBody personOn(World& world, const std::vector<Waypoint>& track)
{
	MovingBody person;
	person.name = person.kind = "person";
	person.mesh = personMesh(1.75, 0.25);
	person.material = world.materialNamed("person");
	person.radius_m = 0.25;
	person.track = track;
	return person;
}

double gapTo(const SimulatedRobot& robot, const RayScene& scene)
{
	const Vector3d person = scene.placement().front().translation();
	return (person - robot.trueState().position_in_map).head<2>().norm() - 0.25 - 0.22;
}
}  // namespace

TEST(RobotContact, StopsAtAWallAndCountsOneTouch)
{
	const World world = wallAt(2.0);
	RayScene scene(world);
	SimulatedRobot robot(scene, {}, {}, {}, 1);
	run(robot, forward(0.5), 10.0);
	EXPECT_NEAR(robot.trueState().position_in_map.x(), 2.0 - 0.22, 1e-4);
	EXPECT_LE(robot.trueState().velocity_mps.norm(), 0.02);
	ASSERT_EQ(robot.contacts().size(), 1U);
	// A quarter of a metre while it speeds up, the rest at half a metre a second.
	EXPECT_NEAR(robot.contacts()[0].t_s, 1.0 + (1.78 - 0.25) / 0.5, 0.06);

	run(robot, forward(-0.5), 1.0);
	EXPECT_EQ(robot.contacts().size(), 1U);
	run(robot, forward(0.5), 5.0);
	EXPECT_EQ(robot.contacts().size(), 2U);
}

TEST(RobotContact, MayTurnOnTheSpotBesideAWallAndDriveAlongIt)
{
	const World world = wallAt(2.0);
	RayScene scene(world);
	SimulatedRobot robot(scene, {}, {}, {1.77, 0, 0, M_PI / 2, 0, 0}, 1);
	run(robot, forward(0.0, 1.0), 3.0);
	EXPECT_TRUE(robot.contacts().empty());
	SimulatedRobot along(scene, {}, {}, {1.77, 0, 0, M_PI / 2, 0, 0}, 1);
	run(along, forward(0.5), 4.0);
	EXPECT_TRUE(along.contacts().empty());
	EXPECT_GT(along.trueState().position_in_map.y(), 1.5);
}

TEST(RobotContact, NeverPassesAThinWallHoweverFastAndCoarse)
{
	const World world = wallAt(3.0, 0.001);
	RayScene scene(world);
	RobotConfig racer;
	racer.radius_m = 0.05;
	racer.max_speed_mps = racer.max_acceleration_mps2 = 20.0;
	SimulatedRobot robot(scene, racer, {}, {}, 1);
	run(robot, forward(20.0), 2.0, 0.1);
	EXPECT_NEAR(robot.trueState().position_in_map.x(), 2.95, 1e-3);
}

TEST(RobotContact, AMavMeetsTheCeiling)
{
	World world;
	addBox(world, {{-2, -2, 2.5}, {2, 2, 2.6}});
	RayScene scene(world);
	RobotConfig mav;
	mav.kind = RobotKind::mav;
	mav.height_m = 0.25;
	SimulatedRobot robot(scene, mav, {}, {0, 0, 1, 0, 0, 0}, 1);
	Command up;
	up.velocity_mps = {0, 0, 0.5};
	run(robot, up, 6.0);
	EXPECT_NEAR(robot.trueState().position_in_map.z(), 2.5 - 0.125, 1e-4);
	EXPECT_EQ(robot.contacts().size(), 1U);
}

TEST(RobotContact, ACapsuleFitsWhereACylindersRimDoesNot)
{
	World world;
	addBox(world, {{1.0, -1.0, 0.55}, {1.5, 1.0, 1.0}});  // a shelf at the height of the body's top
	RayScene scene(world);
	SimulatedRobotConfig capsule;
	capsule.body = BodyShape::capsule;
	SimulatedRobot flat(scene, {}, {}, {}, 1), round(scene, {}, capsule, {}, 1);
	run(flat, forward(0.5), 6.0);
	run(round, forward(0.5), 6.0);
	EXPECT_NEAR(flat.trueState().position_in_map.x(), 1.0 - 0.22, 1e-3);
	// The upper half sphere is around z = 0.60 − 0.22; at z = 0.55 it is √(0.22² − 0.17²) wide.
	EXPECT_NEAR(round.trueState().position_in_map.x(), 1.0 - std::sqrt(0.22 * 0.22 - 0.17 * 0.17), 1e-3);
}

TEST(RobotContact, IsNeverInsideAnythingOnAWildDrive)
{
	Random random(3);
	World world;
	for (int i = 0; i < 30; ++i)
	{
		const Vector3d low(random.uniform(-3, 3), random.uniform(-3, 3), 0.0);
		if (low.head<2>().norm() < 0.8) continue;
		addBox(world, {low, low + Vector3d(0.3, 0.2, 1.0)});
	}
	RayScene scene(world);
	SimulatedRobot robot(scene, {}, {}, {}, 2);
	for (int i = 0; i < 1500; ++i)
	{
		robot.advance(forward(random.uniform(-0.3, 0.6), random.uniform(-1, 1)), 0.1);
		ASSERT_FALSE(robot.touchesAt(robot.trueState().position_in_map)) << "step " << i;
	}
	EXPECT_GT(robot.contacts().size(), 3U);
}

TEST(RobotContact, RefusesToStartInsideSomething)
{
	const World world = wallAt(0.1);
	RayScene scene(world);
	try
	{
		const SimulatedRobot robot(scene, {}, {}, {}, 1);
		FAIL() << "it started inside a wall";
	}
	catch (const ConfigError& error)
	{
		EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("radius 0.22"), testing::HasSubstr("(0, 0, 0)")));
	}
}

TEST(RobotContact, SameCommandsAndSeedGiveTheSame)
{
	const World world = wallAt(1.0);
	RayScene scene(world);
	SimulatedRobot a(scene, {}, {}, {}, 9), b(scene, {}, {}, {}, 9), c(scene, {}, {}, {}, 10);
	for (SimulatedRobot* robot : {&a, &b, &c}) run(*robot, forward(0.4, 0.2), 3.0);
	EXPECT_EQ(a.estimate(), b.estimate());
	EXPECT_EQ(a.imu().specific_force_mps2, b.imu().specific_force_mps2);
	EXPECT_EQ(a.trueState().position_in_map, c.trueState().position_in_map);
	EXPECT_NE(a.estimate(), c.estimate());
	EXPECT_NE(a.imu().specific_force_mps2, c.imu().specific_force_mps2);
}

TEST(RobotMovers, APersonStopsFortyCentimetresBeforeTheRobot)
{
	World world;
	world.moving.push_back(personOn(world, {{0.0, {4.0, 0.1}, 0.0, M_PI}, {10.0, {-4.0, 0.1}, 0.0, M_PI}}));
	RayScene scene(world);
	SimulatedRobot robot(scene, {}, {}, {}, 1);
	run(robot, {}, 7.0);
	EXPECT_NEAR(gapTo(robot, scene), 0.4, 0.02);
	EXPECT_TRUE(robot.contacts().empty());
	// It goes on when the robot has left its way.
	run(robot, forward(-0.5), 4.0);
	EXPECT_LT(scene.placement().front().translation().x(), 0.5);
}

TEST(RobotMovers, OneThatWaitedLongTurnsBack)
{
	World world;
	world.moving.push_back(personOn(world, {{0.0, {3.0, 0.0}, 0.0, M_PI}, {6.0, {-3.0, 0.0}, 0.0, M_PI}}));
	RayScene scene(world);
	SimulatedRobot robot(scene, {}, {}, {}, 1);
	double nearest = HUGE_VAL;
	for (int i = 0; i < 180; ++i)
	{
		robot.advance({}, 0.05);
		nearest = std::min(nearest, gapTo(robot, scene));
	}
	EXPECT_GT(nearest, 0.37);
	EXPECT_GT(scene.placement().front().translation().x(), 1.5);
	EXPECT_GT(scene.placement().front().linear().col(0).x(), 0.99);  // it faces where it walks
}

TEST(RobotMovers, WalksAwayFromARobotThatComesCloseFromBehind)
{
	World world;
	world.moving.push_back(personOn(world, {{0.0, {0.7, 0.0}, 0.0, 0.0}, {5.0, {5.7, 0.0}, 0.0, 0.0}}));
	RayScene scene(world);
	SimulatedRobot robot(scene, {}, {}, {}, 1);
	run(robot, {}, 2.0);
	EXPECT_NEAR(scene.placement().front().translation().x(), 2.7, 0.06);
}

TEST(RobotMovers, FollowTheirTrackRoundAndRound)
{
	World world;
	world.moving.push_back(personOn(
	    world, {{0.0, {5, 0}, 0, 0}, {4.0, {9, 0}, 0, M_PI / 2}, {8.0, {9, 4}, 0, -M_PI}, {12.0, {5, 0}, 0, 0}}));
	Movers movers(world);
	for (int i = 0; i < 140; ++i) movers.advance(0.1, {{-50, 0}, 0.2});  // 14 s = 2 s into the second round
	EXPECT_LT((movers.placement().front().translation() - Vector3d(7, 0, 0)).norm(), 1e-6);
	EXPECT_NEAR(std::atan2(movers.placement().front().linear()(1, 0), movers.placement().front().linear()(0, 0)),
	            M_PI / 4, 1e-9);
	world.moving.front().loop = false;
	Movers once(world);
	for (int i = 0; i < 300; ++i) once.advance(0.1, {{-50, 0}, 0.2});
	EXPECT_LT((once.placement().front().translation() - Vector3d(5, 0, 0)).norm(), 1e-6);
}

TEST(RobotMovers, ARobotThatDrivesIntoAPersonIsCounted)
{
	World world;
	world.moving.push_back(personOn(world, {{0.0, {1.5, 0.0}, 0.0, 0.0}}));
	RayScene scene(world);
	SimulatedRobot robot(scene, {}, {}, {}, 1);
	run(robot, forward(0.5), 6.0);
	EXPECT_EQ(robot.contacts().size(), 1U);
	EXPECT_LT(robot.trueState().position_in_map.x(), 1.5 - 0.22);
}
