// A simulated depth camera: what a Kinect, an Xtion or an ideal sensor would see of a world.
#pragma once

#include <explore/config/simulated_camera.h>
#include <explore/simulation/ray_scene.h>

#include <cstdint>
#include <vector>

namespace explore::simulation
{
struct CameraShot
{
	DepthImage depth;
	std::vector<std::uint8_t> rgb;  ///< row-major, 3 bytes a pixel; empty without color
};

/** One shot from map_from_camera (camera axes: x forward, y left, z up). The same arguments give the same bytes,
 *  whatever the number of threads; `seed` is that of this shot alone. */
CameraShot takeShot(const RayScene& scene, const DepthCameraConfig& config, const Eigen::Isometry3d& map_from_camera,
                    std::uint64_t seed);
}  // namespace explore::simulation
