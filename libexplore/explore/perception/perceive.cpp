#include <explore/perception/obstacles.h>
#include <explore/perception/perceive.h>
#include <explore/perception/perceive_full.h>

#include <array>
#include <utility>

namespace explore
{
namespace
{
Ground groundResult(const FoundPlane& found, const Eigen::Vector3d& camera_in_robot)
{
	return {found.plane, found.plane.signedDistance(camera_in_robot), found.inliers.size(), true};
}

/** Algorithm 1, lines 7–25: everything that stands on the ground. */
void perceiveWalls(Percepts& percepts, std::size_t filtered_count, const Eigen::Vector3d& camera_in_robot,
                   const PerceptionConfig& config, RandomEngine& random)
{
	const Plane& ground = percepts.ground->plane;
	const auto walls = findWalls(percepts.obstacles_in_robot, filtered_count, ground, camera_in_robot, config.walls,
	                             config.planes, random);
	for (const WallPatch& wall : walls)
	{
		percepts.walls.push_back(wall.wall);
		for (Door& door : findDoors(wall, ground, config.door_gaps)) percepts.doors.push_back(std::move(door));
	}
	percepts.vanishing_points = findVanishingPoints(walls, ground, camera_in_robot, config.vanishing_points);
}
}  // namespace

void describe(FieldVisitor& fields, PerceptionConfig& config)
{
	static constexpr std::array<std::string_view, 2> kMethods{"full", "paper"};
	fields.section("perception", "From a depth image to ground, walls, doors and vanishing points (doc/method.md).");
	fields.choice("method", config.method, kMethods,
	              "full: with evidence from every ray, verdict and confidence; paper: Xu et al. 2015, Algorithm 1.");
	fields.choice("leave_out", config.leave_out, kRemedyNames,
	              "full only: switches one of its parts off, to see what it buys.");
	fields.integer("seed", config.seed, {0, 2147483647}, "", "Of every random choice: same seed, same result.");
	describe(fields, config.range_filter);
	describe(fields, config.near_field);
	describe(fields, config.voxel_grid);
	describe(fields, config.planes);
	describe(fields, config.ground);
	describe(fields, config.walls);
	describe(fields, config.door_gaps);
	describe(fields, config.vanishing_points);
	describe(fields, config.sensor_noise);
	describe(fields, config.level);
	describe(fields, config.upright_walls);
	describe(fields, config.openings);
	describe(fields, config.corridor);
	describe(fields, config.corridor_ends);
	describe(fields, config.obstacles);
}

PointCloud filteredVoxels(const DepthFrame& frame, const RangeFilterConfig& range_filter,
                          const VoxelGridConfig& voxel_grid)
{
	VoxelGrid grid(reachOf(frame, range_filter), voxel_grid);
	rangeFilter(frame, range_filter, [&](const PointBlock& points_in_robot) { grid.add(points_in_robot); });
	return grid.centroids();
}

namespace
{
Percepts perceivePaper(const DepthFrame& frame, const PerceptionConfig& config)
{
	RandomEngine random(static_cast<RandomEngine::result_type>(config.seed));
	const Eigen::Vector3d camera_in_robot = isometryOf(frame.robot_from_camera).translation();
	const Eigen::Vector3d up = frame.up_in_robot.value_or(Eigen::Vector3d::UnitZ());

	Percepts percepts;
	const PointCloud filtered = filteredVoxels(frame, config.range_filter, config.voxel_grid);  // P_f
	const auto ground = findGround(filtered, {up, camera_in_robot}, config.ground, config.planes, random);
	percepts.obstacles_in_robot = obstaclePoints(filtered, ground);
	if (ground)
	{
		percepts.ground = groundResult(*ground, camera_in_robot);
		perceiveWalls(percepts, filtered.size(), camera_in_robot, config, random);
	}
	percepts.near_field = nearField(frame, ground ? std::optional(ground->plane) : std::nullopt);
	return percepts;
}
}  // namespace

Percepts perceive(const DepthFrame& frame, const PerceptionConfig& config, const RobotConfig& robot,
                  PerceptionMemory& memory)
{
	if (config.method == PerceptionMethod::paper || frame.image.empty()) return perceivePaper(frame, config);
	return perceiveFull(frame, config, robot, memory);
}

Percepts perceive(const DepthFrame& frame, const PerceptionConfig& config, const RobotConfig& robot)
{
	PerceptionMemory memory;
	return perceive(frame, config, robot, memory);
}
}  // namespace explore
