#include <explore/core/geometry.h>
#include <explore/perception/range_filter.h>

#include <algorithm>

namespace explore
{
namespace
{
/** The rays of one camera, turned into the robot frame: point = origin + depth · (row part + column part). */
struct RobotRays
{
	explicit RobotRays(const DepthFrame& frame)
	{
		const CameraIntrinsics& camera = frame.image.intrinsics;
		const Eigen::Isometry3d robot_from_camera = isometryOf(frame.robot_from_camera);
		origin = robot_from_camera.translation().cast<float>();
		const auto turned = [&](const Eigen::Vector3d& ray)
		{ return Eigen::Vector3f((robot_from_camera.linear() * ray).cast<float>()); };
		const Eigen::Vector3d centre_ray = rayOfPixel(camera, camera.cx_px, camera.cy_px);
		for (int v = 0; v < camera.height_px; ++v) row_part.push_back(turned(rayOfPixel(camera, camera.cx_px, v)));
		for (int u = 0; u < camera.width_px; ++u)
			column_part.push_back(turned(rayOfPixel(camera, u, camera.cy_px) - centre_ray));
	}
	Eigen::Vector3f origin;
	std::vector<Eigen::Vector3f> row_part;
	PointCloud column_part;
};

/** Writes the row's points that are in range to the front of `row`; returns how many. */
std::size_t computeRow(const float* depth_m, const RobotRays& rays, const Eigen::Vector3f& row_part, float max_range_m,
                       PointCloud& row)
{
	std::size_t count = 0;
	for (std::size_t u = 0; u < row.size(); ++u)
	{
		const float depth = depth_m[u];
		row.x[count] = rays.origin.x() + depth * (row_part.x() + rays.column_part.x[u]);
		row.y[count] = rays.origin.y() + depth * (row_part.y() + rays.column_part.y[u]);
		row.z[count] = rays.origin.z() + depth * (row_part.z() + rays.column_part.z[u]);
		// Written always, counted only when in range: no branch to mispredict.
		count += static_cast<std::size_t>(depth > 0.0F) & static_cast<std::size_t>(depth <= max_range_m);
	}
	return count;
}

void filterImage(const DepthFrame& frame, float max_range_m, const std::function<void(const PointBlock&)>& take)
{
	const RobotRays rays(frame);
	const std::size_t width = rays.column_part.size();
	PointCloud row;
	row.resize(width);
	for (std::size_t v = 0; v < rays.row_part.size(); ++v)
	{
		const std::size_t count = computeRow(&frame.image.depth_m[v * width], rays, rays.row_part[v], max_range_m, row);
		take({row.x.data(), row.y.data(), row.z.data(), count});
	}
}

void filterCloud(const DepthFrame& frame, float max_range_m, const std::function<void(const PointBlock&)>& take)
{
	const Eigen::Isometry3f robot_from_camera = isometryOf(frame.robot_from_camera).cast<float>();
	PointCloud points_in_robot;
	for (std::size_t i = 0; i < frame.points_in_camera.size(); ++i)
	{
		const Eigen::Vector3f point_in_camera = frame.points_in_camera[i];
		const float range_m = point_in_camera.norm();
		if (range_m > 0.0F && range_m <= max_range_m) points_in_robot.push_back(robot_from_camera * point_in_camera);
	}
	take(blockOf(points_in_robot));
}
}  // namespace

void describe(FieldVisitor& fields, RangeFilterConfig& config)
{
	fields.real("max_range", config.max_range_m, {0.5, 100.0}, "m",
	            "Range filter: points beyond are removed (paper: 5 m; 8 m for simulated warehouses).");
}

void rangeFilter(const DepthFrame& frame, const RangeFilterConfig& config,
                 const std::function<void(const PointBlock&)>& take)
{
	const auto filter = frame.image.empty() ? filterCloud : filterImage;
	filter(frame, static_cast<float>(config.max_range_m), take);
}

PointCloud rangeFilter(const DepthFrame& frame, const RangeFilterConfig& config)
{
	PointCloud points_in_robot;
	points_in_robot.reserve(frame.image.depth_m.size());
	const auto append = [&](const PointBlock& block)
	{
		points_in_robot.x.insert(points_in_robot.x.end(), block.x, block.x + block.count);
		points_in_robot.y.insert(points_in_robot.y.end(), block.y, block.y + block.count);
		points_in_robot.z.insert(points_in_robot.z.end(), block.z, block.z + block.count);
	};
	rangeFilter(frame, config, append);
	return points_in_robot;
}

Eigen::AlignedBox3f reachOf(const DepthFrame& frame, const RangeFilterConfig& config)
{
	const Eigen::Isometry3d robot_from_camera = isometryOf(frame.robot_from_camera);
	const Eigen::Vector3d center = robot_from_camera.translation();
	if (frame.image.empty())
	{
		const Eigen::Vector3d range = Eigen::Vector3d::Constant(config.max_range_m);
		return Eigen::AlignedBox3d(center - range, center + range).cast<float>();
	}
	const CameraIntrinsics& camera = frame.image.intrinsics;
	Eigen::AlignedBox3d box(center);
	for (const int u : {0, camera.width_px - 1})
		for (const int v : {0, camera.height_px - 1})
			box.extend(robot_from_camera * (config.max_range_m * rayOfPixel(camera, u, v)));
	return box.cast<float>();
}
}  // namespace explore
