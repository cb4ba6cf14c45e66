// How far the body can truly go, against closed forms and against stepping through the world.
#include <explore/core/geometry.h>
#include <explore/simulation/free_paths.h>
#include <explore/simulation/random.h>
#include <explore/simulation/robot_body.h>

#include <gmock/gmock.h>

#include <cmath>

#include "box_worlds.h"

using namespace explore;
using namespace explore::simulation;
using namespace explore::test;
using mrpt::poses::CPose3D;

namespace
{
/** Four walls, their faces `half_m` from the middle; floor and ceiling. */
World room(double half_m, double ceiling_m)
{
	World world;
	const double out = half_m + 0.2;
	addBox(world, {{half_m, -out, 0.0}, {out, out, ceiling_m}});
	addBox(world, {{-out, -out, 0.0}, {-half_m, out, ceiling_m}});
	addBox(world, {{-out, half_m, 0.0}, {out, out, ceiling_m}});
	addBox(world, {{-out, -out, 0.0}, {out, -half_m, ceiling_m}});
	addBox(world, {{-out, -out, -0.2}, {out, out, 0.0}});
	addBox(world, {{-out, -out, ceiling_m}, {out, out, ceiling_m + 0.2}});
	return world;
}

TruthFreePaths pathsIn(const World& world, const RobotConfig& robot, const CPose3D& map_from_robot)
{
	const RayScene scene(world);
	return freePaths(scene, robot, map_from_robot);
}

float at(const TruthFreePaths& paths, std::size_t elevation, int azimuth_deg)
{
	const int azimuth = (azimuth_deg + TruthFreePaths::kAzimuths) % TruthFreePaths::kAzimuths;
	return paths.free_m.at(elevation * TruthFreePaths::kAzimuths + static_cast<std::size_t>(azimuth));
}

/** The first of many small steps at which the body touches something. */
double steppedPath(const RayScene& scene, const VerticalCylinder& body, const Vector3d& direction, double reach_m)
{
	for (double way = 0.0; way < reach_m; way += 0.002)
		if (scene.touchesCylinder(body.base + way * direction, body.radius_m, body.height_m)) return way;
	return reach_m;
}

World randomClutter(Random& random, int boxes)
{
	World world;
	for (int i = 0; i < boxes; ++i)
	{
		Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
		const double range = random.uniform(0.8, 4.0), azimuth = random.uniform(-M_PI, M_PI);
		placed.translate(Vector3d(range * std::cos(azimuth), range * std::sin(azimuth), random.uniform(-1.0, 1.5)));
		placed.rotate(Eigen::AngleAxisd(random.uniform(0.0, 3.0),
		                                Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), 0.5).normalized()));
		TriangleMesh piece;
		append(piece, boxMesh({random.uniform(0.01, 0.8), random.uniform(0.01, 0.8), random.uniform(0.01, 0.8)}),
		       placed);
		world.add("box", piece, world.materialNamed("grey"));
	}
	return world;
}

void expectSameAsStepping(const RobotConfig& robot, std::uint64_t seed)
{
	Random random(seed);
	for (int trial = 0; trial < 12; ++trial)
	{
		const World world = randomClutter(random, 12);
		const RayScene scene(world);
		const CPose3D pose(0.1, -0.05, 0.2, random.uniform(-3.0, 3.0), 0.05, -0.1);
		const TruthFreePaths paths = freePaths(scene, robot, pose);
		for (int i = 0; i < 60; ++i)
		{
			const auto elevation =
			    static_cast<std::size_t>(random.integer(0, static_cast<int>(paths.elevations_rad.size()) - 1));
			const int azimuth = random.integer(0, 359);
			const double up = paths.elevations_rad[elevation], yaw = pose.yaw() + azimuth * kDegree_rad;
			const Vector3d direction(std::cos(up) * std::cos(yaw), std::cos(up) * std::sin(yaw), std::sin(up));
			const double stepped = steppedPath(scene, bodyAt(robot, {0.1, -0.05, 0.2}), direction, paths.cap_m);
			EXPECT_NEAR(at(paths, elevation, azimuth), stepped, 0.01)
			    << "trial " << trial << ", azimuth " << azimuth << ", elevation " << up;
		}
	}
}
}  // namespace

TEST(TruthFreePaths, InARoomTheyEndARadiusBeforeTheWalls)
{
	const RobotConfig robot;
	const TruthFreePaths paths = pathsIn(room(3.0, 2.5), robot, {0.5, 0.0, 0.0, 0.3, 0, 0});
	ASSERT_EQ(paths.free_m.size(), 360U);
	ASSERT_EQ(paths.elevations_rad, std::vector{0.0});
	for (int i = 0; i < 360; ++i)
	{
		const double azimuth = 0.3 + i * kDegree_rad, c = std::cos(azimuth), s = std::sin(azimuth);
		const double along_x = c > 0 ? (2.5 - 0.22) / c : (3.5 - 0.22) / -c, along_y = (3.0 - 0.22) / std::abs(s);
		EXPECT_NEAR(at(paths, 0, i), std::min(along_x, along_y), 1e-3) << i;
	}
}

TEST(TruthFreePaths, AnEdgeIsMetByTheRoundOfTheBody)
{
	World world;
	addBox(world, {{2.0, 0.1, 0.0}, {3.0, 1.0, 1.0}});
	const TruthFreePaths paths = pathsIn(world, {}, {});
	EXPECT_NEAR(at(paths, 0, 0), 2.0 - std::sqrt(0.22 * 0.22 - 0.1 * 0.1), 1e-3);
	EXPECT_FLOAT_EQ(at(paths, 0, 180), 8.0F);
}

TEST(TruthFreePaths, AGroundRobotPassesUnderAndOverWhatLeavesItRoom)
{
	const auto ahead = [](double low_z, double high_z)
	{
		World world;
		addBox(world, {{2.0, -1.0, low_z}, {2.2, 1.0, high_z}});
		return at(pathsIn(world, {}, {}), 0, 0);
	};
	EXPECT_FLOAT_EQ(ahead(0.61, 1.0), 8.0F);
	EXPECT_NEAR(ahead(0.59, 1.0), 1.78, 1e-3);
	EXPECT_FLOAT_EQ(ahead(0.0, 0.029), 8.0F);
	EXPECT_NEAR(ahead(0.0, 0.031), 1.78, 1e-3);
}

TEST(TruthFreePaths, AMavClimbsToTheCeilingAndSinksToTheFloor)
{
	const TruthFreePaths paths = pathsIn(room(20.0, 3.0), mav(), {0, 0, 1.0, 0, 0, 0});
	ASSERT_EQ(paths.elevations_rad.size(), 7U);
	EXPECT_NEAR(paths.elevations_rad.front(), -30 * kDegree_rad, 1e-12);
	EXPECT_NEAR(at(paths, 6, 77), (3.0 - 1.125) / std::sin(30 * kDegree_rad), 1e-3);
	EXPECT_NEAR(at(paths, 0, 200), (1.0 - 0.125) / std::sin(30 * kDegree_rad), 1e-3);
	EXPECT_NEAR(at(paths, 1, 10), (1.0 - 0.125) / std::sin(20 * kDegree_rad), 1e-3);
	EXPECT_FLOAT_EQ(at(paths, 3, 10), 8.0F);
}

TEST(TruthFreePaths, AreZeroWhereTheBodyTouchesSomethingAlready)
{
	World world;
	addBox(world, {{0.1, -0.1, 0.2}, {0.3, 0.1, 0.4}});
	for (const float path : pathsIn(world, {}, {}).free_m) EXPECT_EQ(path, 0.0F);
}

TEST(TruthFreePaths, SeeWhatMovesWhereItStandsNow)
{
	World world;
	MovingBody cart;
	cart.mesh = boxMesh({0.5, 0.5, 2.0});
	cart.material = world.materialNamed("grey");
	cart.track = {{0.0, {2.0, 0.0}, 0.0, 0.0}};
	world.moving.push_back(cart);
	RayScene scene(world);
	EXPECT_NEAR(at(freePaths(scene, {}, {}), 0, 0), 2.0 - 0.25 - 0.22, 1e-3);
	Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
	placed.translation() = Vector3d(0.0, -4.0, 0.0);
	scene.place(std::vector{placed});
	EXPECT_FLOAT_EQ(at(freePaths(scene, {}, {}), 0, 0), 8.0F);
	EXPECT_NEAR(at(freePaths(scene, {}, {}), 0, -90), 4.0 - 0.25 - 0.22, 1e-3);
}

TEST(TruthFreePaths, OfAGroundRobotAgreeWithStepping)
{
	expectSameAsStepping({}, 11);
}

TEST(TruthFreePaths, OfAMavAgreeWithStepping)
{
	expectSameAsStepping(mav(), 12);
}
