#include <explore/core/geometry.h>
#include <explore/perception/upright_walls.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "support/analytic_scene.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;

/** What a camera at map_from_camera sees; up is known to the degree of the truth. */
struct Seen
{
	DepthFrame frame;
	LevelView view;
	std::vector<UprightWall> walls;
};

std::unique_ptr<Seen> see(const test::Scene& scene, const CPose3D& map_from_camera, double noise_scale = 1.0,
                          const UprightWallConfig& config = {}, std::uint32_t seed = 1)
{
	auto seen = std::make_unique<Seen>();
	const CPose3D mount(0, 0, map_from_camera.z(), 0, map_from_camera.pitch(), map_from_camera.roll());
	const CPose3D map_from_robot(map_from_camera.x(), map_from_camera.y(), 0, map_from_camera.yaw(), 0, 0);
	test::CameraNoise noise;
	noise.axial_scale = noise_scale;
	noise.seed = seed;
	seen->frame = test::renderFrame(scene, map_from_robot, mount, test::xtionIntrinsics(320, 240), noise);
	seen->frame.up_in_robot = Eigen::Vector3d::UnitZ();
	seen->view = levelView(seen->frame, {}, {}, {}, {});
	seen->walls = findUprightWalls(seen->view, config, {}, 1);
	return seen;
}

/** A true wall in the level frame of `seen`: its normal toward the camera and the camera's distance. */
struct TrueWall
{
	Eigen::Vector2d normal;
	double distance_m;
};

TrueWall trueWall(const Seen& seen, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
	const Eigen::Isometry3d level_from_map =
	    seen.view.pose.robot_from_level.inverse() * isometryOf(seen.frame.map_from_robot).inverse();
	const Eigen::Vector3d p = level_from_map * Eigen::Vector3d(a.x(), a.y(), 0);
	const Eigen::Vector3d q = level_from_map * Eigen::Vector3d(b.x(), b.y(), 0);
	const Eigen::Vector2d along = (q - p).head<2>().normalized();
	Eigen::Vector2d normal(-along.y(), along.x());
	if (normal.dot(p.head<2>()) > 0) normal = -normal;
	return {normal, -normal.dot(p.head<2>())};
}

int countOf(const std::vector<UprightWall>& walls, const TrueWall& truth, double angle_rad, double distance_m)
{
	int count = 0;
	for (const UprightWall& wall : walls)
		count += static_cast<int>(wall.normal.dot(truth.normal) > std::cos(angle_rad) &&
		                          std::abs(wall.offset_m - truth.distance_m) < distance_m);
	return count;
}

test::Scene hall()
{
	test::Scene scene;
	scene.floor(-10, -10, 10, 10);
	return scene;
}

TEST(UprightWalls, OneWallFromAnyPoseAttitudeAndNoise)
{
	std::mt19937 random(11);
	std::uniform_real_distribution<double> unit(-1, 1);
	for (int i = 0; i < 40; ++i)
	{
		const double distance = 2.8 + 1.6 * unit(random), turn = 60 * kDegree_rad * unit(random);
		const Eigen::Vector2d along(-std::sin(turn), std::cos(turn));
		const Eigen::Vector2d foot = distance * Eigen::Vector2d(std::cos(turn), std::sin(turn));
		const Eigen::Vector2d a = foot - 12 * along, b = foot + 12 * along;
		test::Scene scene = hall();
		scene.wall(a, b, 2.6);
		const CPose3D camera(0, 0, 1.1 + 0.3 * unit(random), 0, 25 * kDegree_rad * unit(random),
		                     30 * kDegree_rad * unit(random));
		const auto seen = see(scene, camera, i % 3, {}, static_cast<std::uint32_t>(i));
		const TrueWall truth = trueWall(*seen, a, b);
		ASSERT_FALSE(seen->walls.empty()) << i;
		EXPECT_EQ(seen->walls.size(), 1U) << i << ": a wall found twice, or noise for a wall";
		EXPECT_EQ(countOf(seen->walls, truth, 0.7 * kDegree_rad, 0.03), 1) << i;
	}
}

TEST(UprightWalls, CorridorDirectionIsPreciseAlthoughItsWallsAreSeenAtAGrazingAngle)
{
	std::mt19937 random(12);
	std::uniform_real_distribution<double> unit(-1, 1);
	const test::Scene scene = test::corridorScene(14, {}, {});
	for (int i = 0; i < 20; ++i)
	{
		const CPose3D camera(0.5 * unit(random), 0.4 * unit(random), 0.8, 10 * kDegree_rad * unit(random), 0, 0);
		const auto seen = see(scene, camera, 1.0, {}, static_cast<std::uint32_t>(i));
		for (const double y : {-1.0, 1.0})
			EXPECT_EQ(countOf(seen->walls, trueWall(*seen, {-2, y}, {14, y}), 0.4 * kDegree_rad, 0.02), 1)
			    << i << ' ' << y;
	}
}

TEST(UprightWalls, PiecesBesideAndBetweenDoorsAreOneWall)
{
	test::Scene scene = hall();
	scene.wall({3.5, -1.6}, {3.5, 1.6}, 2.6, {{0.2, 0.9, 2.0}, {1.3, 0.9, 2.0}});
	scene.wall({7.5, -6}, {7.5, 6}, 2.6);
	const auto seen = see(scene, {0, 0, 0.9, 0, 0, 0});
	const TrueWall truth = trueWall(*seen, {3.5, -1.6}, {3.5, 1.6});
	ASSERT_EQ(countOf(seen->walls, truth, 1.0 * kDegree_rad, 0.04), 1);
	EXPECT_NEAR(seen->walls[0].from_m, -1.6, 0.06);
	EXPECT_NEAR(seen->walls[0].to_m, 1.6, 0.06);
}

TEST(UprightWalls, AFarNarrowPieceBelongsToItsWall)
{
	test::Scene scene = hall();
	scene.wall({4, -1.5}, {4, 0.2}, 2.6).wall({4, 1.1}, {4, 1.25}, 2.6).wall({8, -6}, {8, 6}, 2.6);
	const auto seen = see(scene, {0, 0, 0.9, 0, 0, 0});
	ASSERT_EQ(countOf(seen->walls, trueWall(*seen, {4, -1.5}, {4, 0.2}), 1.5 * kDegree_rad, 0.05), 1);
	EXPECT_NEAR(seen->walls[0].from_m, -1.25, 0.06);  // the tangent points to the right
	EXPECT_NEAR(seen->walls[0].to_m, 1.5, 0.06);
}

TEST(UprightWalls, ParallelSurfacesStayApartWhereTheNoisePermitsIt)
{
	test::Scene scene = hall();
	scene.wall({1.6, -3}, {1.6, 0}, 2.6).wall({1.68, 0}, {1.68, 3}, 2.6);
	const auto seen = see(scene, {0, 0, 0.9, 0, 0, 0});
	EXPECT_EQ(countOf(seen->walls, trueWall(*seen, {1.6, -3}, {1.6, 0}), 1.5 * kDegree_rad, 0.02), 1);
	EXPECT_EQ(countOf(seen->walls, trueWall(*seen, {1.68, 0}, {1.68, 3}), 1.5 * kDegree_rad, 0.02), 1);
}

TEST(UprightWalls, LowThingsAndLevelOnesAreNone)
{
	test::Scene scene = hall();
	scene.box({2, 0, 0.12}, {0.6, 1.5, 0.24}).box({2.5, 0.2, 0.75}, {1.2, 1.4, 0.03}).floor(-5, -5, 8, 5, 2.5);
	EXPECT_TRUE(see(scene, {0, 0, 1.2, 0, 0.1, 0})->walls.empty());
}

TEST(UprightWalls, ACornerHasTwoWallsThatEndThere)
{
	test::Scene scene = hall();
	scene.wall({3, -3}, {3, 1}, 2.6).wall({-2, 1}, {3, 1}, 2.6);
	const auto seen = see(scene, {0, 0, 0.9, 0.1, 0, 0});
	ASSERT_EQ(seen->walls.size(), 2U);
	EXPECT_EQ(countOf(seen->walls, trueWall(*seen, {3, -3}, {3, 1}), 0.7 * kDegree_rad, 0.03), 1);
	EXPECT_EQ(countOf(seen->walls, trueWall(*seen, {-2, 1}, {3, 1}), 0.7 * kDegree_rad, 0.03), 1);
	for (const UprightWall& wall : seen->walls)
	{
		const Eigen::Vector2d left = wall.at(wall.from_m), right = wall.at(wall.to_m);
		const Eigen::Isometry3d level_from_map =
		    seen->view.pose.robot_from_level.inverse() * isometryOf(seen->frame.map_from_robot).inverse();
		const Eigen::Vector2d corner = (level_from_map * Eigen::Vector3d(3, 1, 0)).head<2>();
		EXPECT_LT(std::min((left - corner).norm(), (right - corner).norm()), 0.1);
	}
}

TEST(UprightWalls, AFixedToleranceSplitsNoiseIntoMoreWalls)
{
	UprightWallConfig fixed;
	fixed.range_tolerance = false;
	std::size_t with = 0, without = 0;
	for (std::uint32_t i = 0; i < 6; ++i)
	{
		test::Scene scene = hall();
		scene.wall({4.7, -6}, {4.7, 6}, 2.6);
		with += see(scene, {0, 0, 0.9, 0.3, 0, 0}, 2.0, {}, i)->walls.size();
		without += see(scene, {0, 0, 0.9, 0.3, 0, 0}, 2.0, fixed, i)->walls.size();
	}
	EXPECT_EQ(with, 6U);
	EXPECT_GT(without, with);
}

TEST(UprightWalls, ToleranceGrowsWithTheNoiseAcrossTheWall)
{
	const UprightWallConfig config;
	const UprightWall frontal{{-1, 0}, 4.0, -1, 1, 100}, grazing{{0, 1}, 1.0, -4, -1, 100};
	const double sigma = depthSigma(4.0, {});
	EXPECT_NEAR(sigma, 0.0012 + 0.0019 * 3.6 * 3.6, 1e-12);
	EXPECT_NEAR(wallTolerance(frontal, {4, 0}, 4.0, config, {}), 0.02 + 2.5 * sigma, 1e-9);
	EXPECT_NEAR(wallTolerance(grazing, {4, -1}, 4.0, config, {}), 0.02 + 2.5 * sigma * 0.25, 1e-9);
}

TEST(UprightWalls, SameSeedSameWalls)
{
	const auto seen = see(test::corridorScene(8, {2}, {4}), {0, 0, 0.8, 0, 0, 0});
	const auto again = findUprightWalls(seen->view, {}, {}, 1);
	ASSERT_EQ(again.size(), seen->walls.size());
	for (std::size_t i = 0; i < again.size(); ++i)
	{
		EXPECT_EQ(again[i].normal, seen->walls[i].normal);
		EXPECT_EQ(again[i].from_m, seen->walls[i].from_m);
		EXPECT_EQ(again[i].samples, seen->walls[i].samples);
	}
}

TEST(UprightWalls, WhateverTheImageAllNumbersAreFinite)
{
	std::mt19937 random(3);
	DepthFrame frame;
	for (const auto& [width, height] : {std::array{320, 240}, {640, 480}, {8, 6}, {1, 1}, {0, 0}})
		for (const double share : {0.0, 0.02, 1.0})
		{
			frame.image.intrinsics = test::xtionIntrinsics(width, height);
			frame.image.depth_m.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F);
			for (float& depth : frame.image.depth_m)
				if (static_cast<double>(random() % 1000) < 1000 * share)
					depth = static_cast<float>(random() % 60) * 0.1F;
			const LevelView view = levelView(frame, {}, {}, {}, {});
			for (const UprightWall& wall : findUprightWalls(view, {}, {}, 7))
			{
				EXPECT_TRUE(wall.normal.allFinite());
				EXPECT_NEAR(wall.normal.norm(), 1.0, 1e-9);
				EXPECT_GT(wall.offset_m, 0.0);
				EXPECT_LE(wall.from_m, wall.to_m);
				EXPECT_TRUE(std::isfinite(wall.from_m) && std::isfinite(wall.to_m));
			}
		}
}
}  // namespace
}  // namespace explore
