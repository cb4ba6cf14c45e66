// Points with known geometry: what plane and gap tests are made of.
#pragma once

#include <explore/core/point_cloud.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace explore::test
{
/** Uniform in [low, high]. */
inline double uniform(std::mt19937& random, double low, double high)
{
	return std::uniform_real_distribution<double>(low, high)(random);
}

/** A unit vector in any direction. */
inline Eigen::Vector3d randomDirection(std::mt19937& random)
{
	std::normal_distribution<double> gauss;
	return Eigen::Vector3d(gauss(random), gauss(random), gauss(random)).normalized();
}

/** Adds points over the parallelogram, one at random in each cell of step × step, moved by N(0, noise) along its
 * normal. */
inline void addPatch(PointCloud& points, const Eigen::Vector3d& corner, const Eigen::Vector3d& edge_u,
                     const Eigen::Vector3d& edge_v, double step_m, double noise_m, std::mt19937& random)
{
	std::normal_distribution<double> gauss;
	const Eigen::Vector3d normal = edge_u.cross(edge_v).normalized();
	const auto cells_u = static_cast<int>(std::lround(edge_u.norm() / step_m));
	const auto cells_v = static_cast<int>(std::lround(edge_v.norm() / step_m));
	for (int i = 0; i < cells_u; ++i)
		for (int j = 0; j < cells_v; ++j)
			points.push_back((corner + (i + uniform(random, 0, 1)) / cells_u * edge_u +
			                  (j + uniform(random, 0, 1)) / cells_v * edge_v + noise_m * gauss(random) * normal)
			                     .cast<float>());
}

inline void addUniform(PointCloud& points, std::size_t count, double half_size_m, std::mt19937& random)
{
	for (std::size_t i = 0; i < count; ++i)
		points.push_back(Eigen::Vector3d(uniform(random, -half_size_m, half_size_m),
		                                 uniform(random, -half_size_m, half_size_m),
		                                 uniform(random, -half_size_m, half_size_m))
		                     .cast<float>());
}
}  // namespace explore::test
