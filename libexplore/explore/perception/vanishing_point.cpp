#include <explore/perception/vanishing_point.h>

#include <algorithm>

namespace explore
{
namespace
{
/** Walls whose floor lines run parallel. */
struct Group
{
	std::vector<std::size_t> walls;
	Eigen::Vector3d weighted_direction = Eigen::Vector3d::Zero();  ///< sum of unit directions times inliers
	std::size_t inliers = 0;
};

void addTo(Group& group, std::size_t index, const Wall& wall)
{
	// A line has no sign: take the one that agrees with the group.
	const double sign = group.weighted_direction.dot(wall.floor_line.direction) < 0 ? -1.0 : 1.0;
	group.weighted_direction += sign * static_cast<double>(wall.inliers) * wall.floor_line.direction;
	group.walls.push_back(index);
	group.inliers += wall.inliers;
}

std::vector<Group> groupParallel(const std::vector<WallPatch>& walls, double parallel_rad)
{
	std::vector<Group> groups;
	for (std::size_t i = 0; i < walls.size(); ++i)
	{
		const Wall& wall = walls[i].wall;
		const auto parallel = std::ranges::find_if(
		    groups, [&](const Group& group)
		    { return angleBetweenAxes(group.weighted_direction, wall.floor_line.direction) <= parallel_rad; });
		addTo(parallel == groups.end() ? groups.emplace_back() : *parallel, i, wall);
	}
	std::ranges::stable_sort(groups, std::greater{}, &Group::inliers);
	return groups;
}

/** How far the group's walls are seen along `direction`, counted from the camera [m]. */
double furthestAlong(const Group& group, const std::vector<WallPatch>& walls, const Eigen::Vector3d& camera,
                     const Eigen::Vector3d& direction)
{
	double furthest = 0.0;
	for (const std::size_t index : group.walls)
		for (std::size_t i = 0; i < walls[index].inliers_in_robot.size(); ++i)
			furthest = std::max(furthest, direction.dot(walls[index].inliers_in_robot[i].cast<double>() - camera));
	return furthest;
}
}  // namespace

void describe(FieldVisitor& fields, VanishingPointConfig& config)
{
	fields.degrees("parallel_deg", config.parallel_rad, {0.5, 45.0},
	               "Wall-floor lines within this angle lead to one vanishing point.");
}

std::vector<VanishingPoint> findVanishingPoints(const std::vector<WallPatch>& walls, const Plane& ground,
                                                const Eigen::Vector3d& camera_in_robot,
                                                const VanishingPointConfig& config)
{
	std::vector<VanishingPoint> points;
	for (const Group& group : groupParallel(walls, config.parallel_rad))
	{
		const Eigen::Vector3d& sum = group.weighted_direction;
		const Eigen::Vector3d level = sum - sum.dot(ground.normal) * ground.normal;
		// Forward is where the robot looks; across its view the side where more of the walls is seen.
		const Eigen::Vector3d axis = level.normalized();
		const double ahead = furthestAlong(group, walls, camera_in_robot, axis);
		const double behind = furthestAlong(group, walls, camera_in_robot, -axis);
		const Eigen::Vector3d direction = ahead >= behind ? axis : Eigen::Vector3d(-axis);
		points.push_back({camera_in_robot + std::max(ahead, behind) * direction, direction, group.walls, group.inliers,
		                  std::nullopt});
	}
	return points;
}
}  // namespace explore
