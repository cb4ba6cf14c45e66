#include <explore/perception/walls.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace explore
{
namespace
{
bool isVertical(const Plane& plane, const Plane& ground, const WallConfig& config)
{
	return std::numbers::pi / 2 - angleBetweenAxes(plane.normal, ground.normal) <= config.max_tilt_rad;
}

Plane facing(const Plane& plane, const Eigen::Vector3d& point)
{
	return plane.signedDistance(point) < 0 ? plane.flipped() : plane;
}
}  // namespace

void describe(FieldVisitor& fields, WallConfig& config)
{
	fields.degrees("wall_tilt_deg", config.max_tilt_rad, {1.0, 45.0},
	               "A wall may lean this much against the ground's vertical.");
}

std::vector<WallPatch> findWalls(const PointCloud& points, std::size_t filtered_count, const Plane& ground,
                                 const Eigen::Vector3d& camera_in_robot, const WallConfig& config,
                                 const PlaneSearchConfig& planes, RandomEngine& random)
{
	const double enough_left = planes.alpha * static_cast<double>(filtered_count);  // N_p
	std::vector<WallPatch> walls;
	PointCloud rest = points;
	while (static_cast<double>(rest.size()) > enough_left)
	{
		const auto found = dominantPlane(rest, planes, random);
		if (!found) break;
		if (isVertical(found->plane, ground, config))
		{
			const Plane plane = facing(found->plane, camera_in_robot);
			const auto floor_line = intersectionLine(plane, ground, camera_in_robot);
			walls.push_back(
			    {{plane, found->inliers.size(), floor_line.value()}, projectOnto(plane, rest, found->inliers)});
		}
		rest = without(rest, found->inliers);
	}
	return walls;
}

std::optional<Line> intersectionLine(const Plane& wall, const Plane& ground, const Eigen::Vector3d& from)
{
	const Eigen::Vector3d direction = wall.normal.cross(ground.normal);
	if (direction.norm() < 1e-9) return std::nullopt;

	// Paper eq. 4: unknowns x, y, z, λ, μ; x_i · n_i of a point x_i on plane i is −d_i.
	Eigen::Matrix<double, 5, 5> system = Eigen::Matrix<double, 5, 5>::Zero();
	system.topLeftCorner<3, 3>() = 2.0 * Eigen::Matrix3d::Identity();
	system.block<3, 1>(0, 3) = wall.normal;
	system.block<3, 1>(0, 4) = ground.normal;
	system.block<1, 3>(3, 0) = wall.normal.transpose();
	system.block<1, 3>(4, 0) = ground.normal.transpose();
	Eigen::Matrix<double, 5, 1> right_side;
	right_side << 2.0 * from, -wall.d_m, -ground.d_m;
	const Eigen::Matrix<double, 5, 1> solution = system.fullPivLu().solve(right_side);
	return Line{solution.head<3>(), direction.normalized()};
}
}  // namespace explore
