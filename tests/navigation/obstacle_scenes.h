// Obstacle clouds with known geometry, in the robot frame, for the tests of navigation.
#pragma once

#include <explore/navigation/avoider.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace explore::test
{
/** The floor at `height_m` below the robot frame's origin. */
inline Plane floorBelow(double height_m)
{
	return {Eigen::Vector3d::UnitZ(), height_m};
}

/** The whole clearance is asked for at any distance, so that the hull is the same cylinder everywhere. */
inline AvoiderConfig evenClearance()
{
	AvoiderConfig config;
	config.clearance_range_m = 1e12;
	return config;
}

/** Points every 2 cm of an upright wall from a to b, 0.1 m to 1.5 m high. */
inline void addWall(PointCloud& cloud, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
	const int steps = std::max(1, static_cast<int>(std::lround((b - a).norm() / 0.02)));
	for (int i = 0; i <= steps; ++i)
		for (const double z : {0.1, 0.3, 0.5, 1.0, 1.5})
		{
			const Eigen::Vector2d point = a + (b - a) * (static_cast<double>(i) / steps);
			cloud.push_back({static_cast<float>(point.x()), static_cast<float>(point.y()), static_cast<float>(z)});
		}
}

inline PointCloud wallCloud(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
	PointCloud cloud;
	addWall(cloud, a, b);
	return cloud;
}

inline PointCloud randomCloud(std::mt19937& random, int count, double half_extent_m)
{
	std::uniform_real_distribution<double> uniform(-half_extent_m, half_extent_m);
	PointCloud cloud;
	for (int i = 0; i < count; ++i)
	{
		const double x = uniform(random), y = uniform(random), z = uniform(random);
		cloud.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
	}
	return cloud;
}

/** Input for a robot whose frame lies on the seen floor. */
inline AvoiderInput onFloor(const PointCloud& cloud, double desired_rad = 0.0)
{
	AvoiderInput input;
	input.obstacles_in_robot = &cloud;
	input.ground = floorBelow(0.0);
	input.desired_rad = desired_rad;
	return input;
}
}  // namespace explore::test
