// Walls at known places before a camera at the origin that looks along x.
#pragma once

#include <explore/simulation/depth_camera.h>
#include <explore/simulation/shapes.h>

#include <array>
#include <cmath>
#include <vector>

namespace explore::simulation::test
{
/** Adds an upright rectangle (width, height) whose middle is at (distance, 0, 0) + offset, turned about z by
 * `tilt_rad`. */
inline void addWall(World& world, double distance_m, double tilt_rad = 0.0, const std::string& material = "wall",
                    const Eigen::Vector2d& size_m = {60.0, 60.0}, const Eigen::Vector3d& offset_m = {0, 0, 0})
{
	const Eigen::Vector3d middle = Eigen::Vector3d(distance_m, 0.0, 0.0) + offset_m;
	const Eigen::Vector3d across = size_m.x() / 2 * Eigen::Vector3d(-std::sin(tilt_rad), std::cos(tilt_rad), 0.0);
	const Eigen::Vector3d up(0.0, 0.0, size_m.y() / 2);
	TriangleMesh wall;
	const std::array<Eigen::Vector3d, 4> corners{middle - across - up, middle + across - up, middle + across + up,
	                                             middle - across + up};
	for (const Eigen::Vector3d& corner : corners) wall.vertices.push_back(corner.cast<float>());
	wall.triangles = {{0, 1, 2}, {0, 2, 3}};
	world.add(material + std::to_string(world.bodies.size()), wall, world.materialNamed(material));
}

/** Depth of that wall at a pixel. */
inline double wallDepth(const CameraIntrinsics& camera, int u_px, int v_px, double distance_m, double tilt_rad)
{
	const Eigen::Vector3d normal(std::cos(tilt_rad), std::sin(tilt_rad), 0.0);
	return distance_m * normal.x() / normal.dot(rayOfPixel(camera, u_px, v_px));
}

inline CameraShot shotOf(const World& world, const DepthCameraConfig& config, std::uint64_t seed = 1)
{
	const RayScene scene(world);
	return takeShot(scene, config, Eigen::Isometry3d::Identity(), seed);
}

struct Spread
{
	double mean = 0, sigma = 0;
	std::size_t count = 0;
};

inline Spread spreadOf(const std::vector<double>& values)
{
	Spread spread;
	spread.count = values.size();
	for (const double value : values) spread.mean += value / static_cast<double>(values.size());
	for (const double value : values)
		spread.sigma += (value - spread.mean) * (value - spread.mean) / static_cast<double>(values.size());
	spread.sigma = std::sqrt(spread.sigma);
	return spread;
}

/** Measured minus true depth of all returns from that wall. */
inline std::vector<double> residuals(const DepthImage& image, double distance_m, double tilt_rad)
{
	std::vector<double> out;
	for (int v = 0; v < image.intrinsics.height_px; ++v)
		for (int u = 0; u < image.intrinsics.width_px; ++u)
			if (image.at(u, v) > 0.0F)
				out.push_back(static_cast<double>(image.at(u, v)) -
				              wallDepth(image.intrinsics, u, v, distance_m, tilt_rad));
	return out;
}

inline double returnShare(const DepthImage& image)
{
	std::size_t returns = 0;
	for (const float depth : image.depth_m) returns += depth > 0.0F ? 1 : 0;
	return static_cast<double>(returns) / static_cast<double>(image.depth_m.size());
}
}  // namespace explore::simulation::test
