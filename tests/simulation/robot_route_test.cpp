// Following routes and paths: what carries the camera while a log is recorded.
#include <explore/core/errors.h>
#include <explore/simulation/carriers.h>

#include <gmock/gmock.h>

#include <cmath>

#include "box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using mrpt::poses::CPose3D;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace
{
double distanceToSegment(const Vector3d& point, const Vector3d& a, const Vector3d& b)
{
	const double share = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
	return (a + share * (b - a) - point).norm();
}

struct Drive
{
	double worst_m = 0;  ///< away from the route
	double seconds = 0;
	CPose3D end;
	std::vector<std::string> warnings;
};

Drive driven(const World& world, const RobotConfig& robot, const Route& route, double most_s = 120)
{
	RayScene scene(world);
	const auto carrier = carrierOnRoute(scene, robot, {}, route, 1);
	Drive drive;
	for (; drive.seconds < most_s && !carrier->finished(); drive.seconds += 0.1)
	{
		carrier->advanceTo(drive.seconds);
		const CPose3D pose = carrier->truePose();
		double nearest = HUGE_VAL;
		for (std::size_t i = 1; i < route.points_in_map.size(); ++i)
			nearest = std::min(nearest, distanceToSegment({pose.x(), pose.y(), pose.z()}, route.points_in_map[i - 1],
			                                              route.points_in_map[i]));
		drive.worst_m = std::max(drive.worst_m, nearest);
	}
	drive.end = carrier->truePose();
	drive.warnings = carrier->warnings();
	return drive;
}
}  // namespace

TEST(RobotRoute, AGroundRobotFollowsCornersAndStopsAtTheEnd)
{
	const Route route{"zigzag", {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}, {0.5, 4, 0}}};
	const Drive drive = driven({}, {}, route);
	EXPECT_LT(std::hypot(drive.end.x() - 0.5, drive.end.y() - 4.0), 0.1);
	EXPECT_LT(drive.worst_m, 0.25);
	EXPECT_THAT(drive.warnings, IsEmpty());
	// 10.1 m at half a metre a second take 20 s; corners and both ends cost some more.
	EXPECT_GT(drive.seconds, 20.0);
	EXPECT_LT(drive.seconds, 45.0);
}

TEST(RobotRoute, AMavAlsoClimbs)
{
	const Route route{"stairs", {{0, 0, 0.8}, {3, 0, 0.8}, {3, 0, 1.8}, {3, 3, 1.2}}};
	const Drive drive = driven({}, mav(), route);
	EXPECT_LT((Vector3d(drive.end.x(), drive.end.y(), drive.end.z()) - Vector3d(3, 3, 1.2)).norm(), 0.1);
	EXPECT_LT(drive.worst_m, 0.35);
	EXPECT_LT(drive.seconds, 40.0);
}

TEST(RobotRoute, ARouteMayCrossItselfAndComeBack)
{
	const Route route{"eight", {{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 0}}};
	const Drive drive = driven({}, {}, route);
	EXPECT_LT(std::hypot(drive.end.x(), drive.end.y()), 0.1);
	EXPECT_GT(drive.seconds, 25.0);
}

TEST(RobotRoute, EndsEarlyAndSaysSoWhereSomethingIsInTheWay)
{
	World world;
	addBox(world, {{2.0, -3.0, 0.0}, {2.1, 3.0, 2.0}});
	const Drive drive = driven(world, {}, {"through the wall", {{0, 0, 0}, {5, 0, 0}}});
	EXPECT_THAT(drive.warnings, ElementsAre(HasSubstr("in the robot's way")));
	EXPECT_LT(drive.end.x(), 2.0 - 0.22);
	EXPECT_LT(drive.seconds, 40.0);
}

TEST(RobotRoute, WaitsForAPersonWhoCrosses)
{
	World world;
	MovingBody person;
	person.name = person.kind = "person";
	person.mesh = personMesh(1.75, 0.25);
	person.material = world.materialNamed("person");
	person.track = {{0.0, {2.0, -2.6}, 0.0, M_PI / 2}, {6.0, {2.0, 2.6}, 0.0, M_PI / 2}};
	person.loop = false;
	world.moving.push_back(person);
	const Drive drive = driven(world, {}, {"straight", {{0, 0, 0}, {5, 0, 0}}});
	EXPECT_NEAR(drive.end.x(), 5.0, 0.1);
	EXPECT_THAT(drive.warnings, IsEmpty());
}

TEST(RobotRoute, NeedsTwoPointsThatDiffer)
{
	World world;
	RayScene scene(world);
	EXPECT_THROW(carrierOnRoute(scene, {}, {}, {"point", {{1, 1, 0}, {1, 1, 0}}}, 1), ConfigError);
}

TEST(RobotPath, GoesExactlyThroughThePosesAndStraightBetweenThem)
{
	World world;
	addBox(world, {{-5, -5, -0.1}, {5, 5, -0.05}});
	RayScene scene(world);
	const auto carrier =
	    carrierOnPath(scene, mav(), {},
	                  {{0.0, {0, 0, 1, 0, 0, 0}}, {2.0, {1, 2, 1.5, 0.4, 0, 0}}, {3.0, {1, 2, 1.5, 0.4, 0.2, 0}}}, 1);
	EXPECT_EQ(carrier->truePose(), CPose3D(0, 0, 1, 0, 0, 0));
	carrier->advanceTo(0.5);
	EXPECT_LT(carrier->truePose().distanceTo(CPose3D(0.25, 0.5, 1.125, 0, 0, 0)), 1e-9);
	EXPECT_NEAR(carrier->truePose().yaw(), 0.1, 1e-9);
	EXPECT_NEAR(carrier->imu().rate_radps.z(), 0.2, 0.03);
	EXPECT_FALSE(carrier->finished());
	carrier->advanceTo(2.5);
	EXPECT_NEAR(carrier->truePose().pitch(), 0.1, 1e-9);
	// Nose down by 0.1 rad, gravity is felt toward the tail.
	EXPECT_NEAR(carrier->imu().specific_force_mps2.x(), -9.81 * std::sin(0.1), 0.3);
	carrier->advanceTo(3.0);
	EXPECT_TRUE(carrier->finished());
	EXPECT_THAT(carrier->warnings(), IsEmpty());
	EXPECT_LT(carrier->estimate().distanceTo(carrier->truePose()), 0.2);
	EXPECT_GT(carrier->estimate().distanceTo(carrier->truePose()), 0.0);
}

TEST(RobotPath, TellsWhereItTouchesOrLeavesTheWorld)
{
	World world;
	addBox(world, {{-1, -1, -0.1}, {4, 1, 0.0}});
	addBox(world, {{2.005, -1.0, 0.0}, {2.105, 1.0, 1.0}});
	RayScene scene(world);
	const auto carrier = carrierOnPath(scene, {}, {}, {{0.0, {}}, {10.0, {5, 0, 0, 0, 0, 0}}}, 1);
	carrier->advanceTo(10.0);
	// From x = 2.005 − 0.22 to 2.105 + 0.22 it touches: 0.54 m at half a metre a second; beyond x = 4 it is outside.
	EXPECT_THAT(carrier->warnings(), ElementsAre(testing::AllOf(HasSubstr("touches something"),
	                                                            HasSubstr("after 3.58 s"), HasSubstr("1.08 s in all")),
	                                             HasSubstr("leaves the world's bounds: first after 8.02 s")));
}

TEST(RobotPath, RefusesTimesThatDoNotIncrease)
{
	World world;
	RayScene scene(world);
	EXPECT_THROW(carrierOnPath(scene, {}, {}, {}, 1), ConfigError);
	EXPECT_THROW(carrierOnPath(scene, {}, {}, {{0.0, {}}, {1.0, {}}, {1.0, {}}}, 1), ConfigError);
}
