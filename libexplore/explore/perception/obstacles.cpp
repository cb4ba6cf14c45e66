#include <explore/perception/obstacle_tiles.h>
#include <explore/perception/obstacles.h>
#include <explore/perception/range_filter.h>
#include <explore/perception/voxel_grid.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace explore
{
namespace
{
constexpr float kNothing = ObstacleTiles::kNothing;

/** What is an obstacle by its height above the floor [m]. */
struct HeightLimits
{
	float low = -kNothing, top = kNothing;  ///< stands between them, or
	float drop = -kNothing;                 ///< lies below
};

/** The floor that a ground robot stands on; none for a MAV, to which everything is an obstacle. */
std::optional<Plane> floorUnder(const DepthFrame& frame, const std::optional<Plane>& ground, const RobotConfig& robot)
{
	if (robot.kind == RobotKind::mav) return std::nullopt;
	if (ground) return ground;
	return Plane{frame.up_in_robot.value_or(Eigen::Vector3d::UnitZ()), 0.0};
}

HeightLimits limitsOf(double tolerance_m, const RobotConfig& robot, const ObstacleConfig& config)
{
	const double low_m = config.min_height_m + tolerance_m, top_m = robot.height_m + config.overhead_margin_m;
	return {static_cast<float>(low_m), static_cast<float>(top_m), static_cast<float>(-low_m)};
}

/** The rays of the image: point_in_robot = origin + depth · (row part + column part), and the same for heights. */
struct Rays
{
	Eigen::Vector3f origin;
	std::vector<Eigen::Vector3f> row, column;
	float camera_height_m = 0;
	std::vector<float> row_rise, column_rise;  ///< height above the floor per metre of depth

	Rays(const DepthFrame& frame, const std::optional<Plane>& floor)
	{
		const CameraIntrinsics& camera = frame.image.intrinsics;
		const Eigen::Isometry3d robot_from_camera = isometryOf(frame.robot_from_camera);
		const Eigen::Vector3d up = floor ? floor->normal : Eigen::Vector3d::Zero();
		origin = robot_from_camera.translation().cast<float>();
		if (floor) camera_height_m = static_cast<float>(floor->signedDistance(robot_from_camera.translation()));
		const auto turned = [&](double u, double v) -> Eigen::Vector3d
		{ return robot_from_camera.linear() * rayOfPixel(camera, u, v); };
		const Eigen::Vector3d axis = turned(camera.cx_px, camera.cy_px);
		row.reserve(static_cast<std::size_t>(camera.height_px));
		column.reserve(static_cast<std::size_t>(camera.width_px));
		for (int v = 0; v < camera.height_px; ++v)
		{
			const Eigen::Vector3d part = turned(camera.cx_px, v);
			row.emplace_back(part.cast<float>());
			row_rise.push_back(static_cast<float>(up.dot(part)));
		}
		for (int u = 0; u < camera.width_px; ++u)
		{
			const Eigen::Vector3d part = turned(u, camera.cy_px) - axis;
			column.emplace_back(part.cast<float>());
			column_rise.push_back(static_cast<float>(up.dot(part)));
		}
	}
	[[nodiscard]] Eigen::Vector3f point(std::size_t u, std::size_t v, float depth_m) const
	{
		return origin + depth_m * (row[v] + column[u]);
	}
};

/** How much of its depth [1] two neighbours on one surface may differ. */
float neighbourTolerance(const ObstacleConfig& config, const SensorNoiseConfig& noise)
{
	constexpr double kSlant = 0.01, kStep_m = 0.5;
	double share = 0.0;
	for (double depth_m = kStep_m; depth_m < config.max_range_m + kStep_m; depth_m += kStep_m)
		share = std::max(share, depthSigma(depth_m, noise) / depth_m);
	return static_cast<float>(kSlant + config.tolerance_sigmas * std::numbers::sqrt2 * share);
}

/** How high [m] noise may lift the flat floor that row v sees, at most. */
double floorNoise(const Rays& rays, std::size_t v, const ObstacleConfig& config, const SensorNoiseConfig& noise)
{
	double most_m = 0.0;
	for (const std::size_t u : {std::size_t{0}, rays.column.size() / 2, rays.column.size() - 1})
	{
		const double fall = -(rays.row_rise[v] + rays.column_rise[u]);
		const bool sees_floor = fall * config.max_range_m > rays.camera_height_m;
		const double depth_m = sees_floor ? rays.camera_height_m / fall : config.max_range_m;
		const double spread_m = config.tolerance_sigmas * depthSigma(depth_m, noise) * std::abs(fall);
		most_m = std::max(most_m, config.floor_slack * depth_m + (sees_floor ? spread_m : 0.0));
	}
	return most_m;
}

/** Three rows of the image, the middle one of which is looked at. */
struct RowView
{
	const float *above, *here, *below;
	std::size_t count;
};

struct RowTest
{
	HeightLimits height;
	float camera_height_m = 0, row_rise = 0, max_range_m = 0, neighbour_share = 0;
};

/** For each pixel the depth at which its ray meets an obstacle (the floor's, for a drop); kNothing elsewhere. Written
 *  without branches, so that it is computed several pixels at a time. */
void meetings(const RowView& row, const float* column_rise, const RowTest& test, float* meeting_m)
{
	meeting_m[0] = meeting_m[row.count - 1] = kNothing;
	for (std::size_t u = 1; u + 1 < row.count; ++u)
	{
		const float depth = row.here[u], near = test.neighbour_share * depth;
		const int alike = static_cast<int>(std::abs(row.here[u - 1] - depth) < near) +
		                  static_cast<int>(std::abs(row.here[u + 1] - depth) < near) +
		                  static_cast<int>(std::abs(row.above[u] - depth) < near) +
		                  static_cast<int>(std::abs(row.below[u] - depth) < near);
		const float height = test.camera_height_m + depth * (test.row_rise + column_rise[u]);
		const int stands = static_cast<int>(height > test.height.low) & static_cast<int>(height < test.height.top);
		const int falls = static_cast<int>(height < test.height.drop);
		const float pierced = depth * test.camera_height_m / (test.camera_height_m - height);
		const float meeting = falls != 0 ? pierced : depth;
		const int counts = static_cast<int>(alike >= 2) & static_cast<int>(depth > 0.0F) &
		                   static_cast<int>(meeting <= test.max_range_m) & (stands | falls);
		meeting_m[u] = counts != 0 ? meeting : kNothing;
	}
}

PointCloud obstaclesInImage(const DepthFrame& frame, const std::optional<Plane>& floor, const RobotConfig& robot,
                            const ObstacleConfig& config, const SensorNoiseConfig& noise)
{
	const Rays rays(frame, floor);
	const std::size_t width = rays.column.size(), height = rays.row.size();
	const TileSize size = tileSize(robot, frame.image.intrinsics);
	RowTest test{
	    {}, rays.camera_height_m, 0.0F, static_cast<float>(config.max_range_m), neighbourTolerance(config, noise)};
	std::vector<float> meeting_m(width);
	ObstacleTiles tiles(frame.image.intrinsics, size, config.min_area_m2);
	PointCloud points_in_robot;
	if (width < 3) return points_in_robot;
	for (std::size_t v = 0; v < height; ++v)
	{
		const float* here = &frame.image.depth_m[v * width];
		test.row_rise = rays.row_rise[v];
		if (floor) test.height = limitsOf(floorNoise(rays, v, config, noise), robot, config);
		meetings({v > 0 ? here - width : here, here, v + 1 < height ? here + width : here, width},
		         rays.column_rise.data(), test, meeting_m.data());
		tiles.add(meeting_m, v);
		if ((v + 1) % size.height != 0 && v + 1 != height) continue;
		for (const auto& pixel : tiles.take())
			points_in_robot.push_back(rays.point(pixel.u, pixel.v, frame.image.depth_m[pixel.v * width + pixel.u]));
	}
	return points_in_robot;
}

PointCloud obstaclesInCloud(const DepthFrame& frame, const std::optional<Plane>& floor, const RobotConfig& robot,
                            const ObstacleConfig& config)
{
	PointCloud voxels = voxelGrid(rangeFilter(frame, {config.max_range_m}), {});
	if (!floor) return voxels;
	const Eigen::Vector3d sensor = isometryOf(frame.robot_from_camera).translation();
	PointCloud points_in_robot;
	for (std::size_t i = 0; i < voxels.size(); ++i)
	{
		const Eigen::Vector3d point = voxels[i].cast<double>();
		const double height_m = floor->signedDistance(point);
		const HeightLimits limits = limitsOf(config.floor_slack * (point - sensor).norm(), robot, config);
		if ((height_m > limits.low && height_m < limits.top) || height_m < limits.drop)
			points_in_robot.push_back(voxels[i]);
	}
	return points_in_robot;
}
}  // namespace

PointCloud obstaclePoints(const PointCloud& points, const std::optional<FoundPlane>& ground)
{
	return ground ? without(points, ground->inliers) : points;
}

void describe(FieldVisitor& fields, ObstacleConfig& config)
{
	fields.real("obstacle_max_range", config.max_range_m, {0.5, 100.0}, "m",
	            "Of the depth image's obstacles: what is further away does not matter yet.");
	fields.real("obstacle_min_height", config.min_height_m, {0.0, 0.5}, "m",
	            "What a ground robot rolls over, up or down; at least [avoider] step_height counts.");
	fields.real("obstacle_overhead_margin", config.overhead_margin_m, {0.0, 1.0}, "m",
	            "What passes this far above a ground robot is no obstacle.");
	fields.real("obstacle_min_area", config.min_area_m2, {0.0, 0.01}, "m^2",
	            "Less of a thing than this, facing the camera, may be noise.");
	fields.real("obstacle_floor_slack", config.floor_slack, {0.0, 0.1}, "",
	            "What the floor may be off per metre of range.");
	fields.real("obstacle_tolerance_sigmas", config.tolerance_sigmas, {0.0, 10.0}, "",
	            "Depth noise that makes no obstacle of a flat floor, in standard deviations.");
}

PointCloud nearObstacles(const DepthFrame& frame, const std::optional<Plane>& ground, const RobotConfig& robot,
                         const ObstacleConfig& config, const SensorNoiseConfig& noise)
{
	const std::optional<Plane> floor = floorUnder(frame, ground, robot);
	return frame.image.empty() ? obstaclesInCloud(frame, floor, robot, config)
	                           : obstaclesInImage(frame, floor, robot, config, noise);
}
}  // namespace explore
