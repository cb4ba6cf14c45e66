// Robot poses in the free space of a labelled world, most of them with a door before them.
#pragma once

#include <explore/simulation/ray_scene.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace explore::test
{
struct SampledPose
{
	Eigen::Vector3d position;
	double yaw_rad = 0, pitch_rad = 0, roll_rad = 0;
};

struct SampleOptions
{
	bool mav = false;
	int count = 60;
	double camera_m = 0.5;     ///< height of a ground robot's camera
	double door_share = 0.65;  ///< of the poses that look at a door
	Eigen::AlignedBox2d within{Eigen::Vector2d(-1e6, -1e6), Eigen::Vector2d(1e6, 1e6)};
};

/** `options.count` poses, fewer where the world has not enough places. The same arguments give the same poses. Throws
 *  std::runtime_error where no floor around the world's spawns is free. */
std::vector<SampledPose> samplePoses(const simulation::RayScene& scene, const SampleOptions& options,
                                     std::uint64_t seed);
}  // namespace explore::test
