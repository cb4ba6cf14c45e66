#include <explore/simulation/sensor_view.h>
#include <gtest/gtest.h>

#include "depth_camera_worlds.h"
#include "soup_worlds.h"

namespace explore::simulation::test
{
namespace
{
class RandomView : public testing::TestWithParam<unsigned>
{
};

/** A room's back wall behind a soup of triangles, some of glass, and moving bodies. */
World clutteredRoom(std::mt19937& random)
{
	World world = soupWorld(random, 60, 4);
	addWall(world, 4.0, 0.2, "wall");
	return world;
}

TEST_P(RandomView, ShadowFallsWhereSomethingStandsBetweenSurfaceAndProjector)
{
	std::mt19937 random(GetParam());
	const World world = clutteredRoom(random);
	const RayScene scene(world);
	DepthCameraConfig config = depthCamera("xtion", 200);
	config.glass_dropout = 0.2;
	Eigen::Isometry3d map_from_camera(Eigen::AngleAxisd(uniform(random, -0.3, 0.3), randomDirection(random)));
	map_from_camera.pretranslate(Eigen::Vector3d(-4.5, uniform(random, -1, 1), uniform(random, -1, 1)));
	const SensorView with = lookAround(scene, config, map_from_camera, 5, true);
	const SensorView without = lookAround(scene, config, map_from_camera, 5, false);
	EXPECT_EQ(with.depth_m, without.depth_m);
	const Eigen::Vector3d projector = map_from_camera * Eigen::Vector3d(0.0, -config.baseline_m, 0.0);
	int dark = 0, wrong = 0;
	for (int v = 0; v < config.intrinsics.height_px; ++v)
		for (int u = 0; u < config.intrinsics.width_px; ++u)
		{
			const auto pixel = static_cast<std::size_t>(v * config.intrinsics.width_px + u);
			if (with.depth_m[pixel] == 0.0F || without.lost[pixel] != 0) continue;
			const Eigen::Vector3d point =
			    map_from_camera * (static_cast<double>(with.depth_m[pixel]) * rayOfPixel(config.intrinsics, u, v));
			const bool expected = scene.occluded(projector, point, 0.005, Panes::pass);
			dark += expected ? 1 : 0;
			wrong += expected != (with.lost[pixel] != 0) ? 1 : 0;
		}
	EXPECT_GT(dark, 200);
	EXPECT_LE(wrong, 3 + dark / 20) << "only the shadows of what is thinner than a pixel may be missed";
}

TEST_P(RandomView, DepthAndIncidenceAreThoseOfSingleRays)
{
	std::mt19937 random(GetParam());
	const World world = clutteredRoom(random);
	const RayScene scene(world);
	const DepthCameraConfig config = depthCamera("xtion", 90);
	Eigen::Isometry3d map_from_camera = Eigen::Isometry3d::Identity();
	map_from_camera.pretranslate(Eigen::Vector3d(-4.5, 0.2, 0.1));
	const SensorView view = lookAround(scene, config, map_from_camera, 5, true);
	int wrong = 0;
	for (int v = 0; v < config.intrinsics.height_px; ++v)
		for (int u = 0; u < config.intrinsics.width_px; ++u)
		{
			const auto pixel = static_cast<std::size_t>(v * config.intrinsics.width_px + u);
			const Eigen::Vector3d direction = map_from_camera.linear() * rayOfPixel(config.intrinsics, u, v);
			const auto hit = scene.cast(map_from_camera.translation(), direction, 8.4);
			if (hit && world.materials[hit->material].surface == Surface::glass) continue;
			const double cosine = hit ? -direction.normalized().dot(hit->normal.cast<double>()) : 0.0;
			wrong += std::abs(view.depth_m[pixel] - (hit ? hit->distance : 0.0)) > 1e-5 ||
			                 std::abs(static_cast<double>(view.cosine[pixel]) - cosine) > 1e-5
			             ? 1
			             : 0;
		}
	EXPECT_LE(wrong, 3) << "only rays along an edge may differ";
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomView, testing::Values(11U, 12U, 13U, 14U, 15U, 16U));
}  // namespace
}  // namespace explore::simulation::test
