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
		const CameraIntrinsics& intrinsics = frame.image.intrinsics;
		const Eigen::Isometry3d robot_from_camera = isometryOf(frame.robot_from_camera);
		origin = robot_from_camera.translation().cast<float>();
		const auto turned = [&](const Eigen::Vector3d& ray)
		{ return Eigen::Vector3f((robot_from_camera.linear() * ray).cast<float>()); };
		const Eigen::Vector3d centre_ray = rayOfPixel(intrinsics, intrinsics.cx_px, intrinsics.cy_px);
		for (int v = 0; v < intrinsics.height_px; ++v)
			row_part.push_back(turned(rayOfPixel(intrinsics, intrinsics.cx_px, v)));
		for (int u = 0; u < intrinsics.width_px; ++u)
			column_part.push_back(turned(rayOfPixel(intrinsics, u, intrinsics.cy_px) - centre_ray));
	}
	Eigen::Vector3f origin;
	std::vector<Eigen::Vector3f> row_part;
	PointCloud column_part;
};

/** Points of one image row, appended to `points` by whole blocks: cheaper than point by point. */
class RowBuffer
{
public:
	explicit RowBuffer(std::size_t width) { m_points.resize(width); }

	void fill(const float* depth_m, const RobotRays& rays, std::size_t v, float max_range_m)
	{
		const Eigen::Vector3f row = rays.row_part[v];
		m_count = 0;
		for (std::size_t u = 0; u < m_points.size(); ++u)
		{
			const float depth = depth_m[u];
			m_points.x[m_count] = rays.origin.x() + depth * (row.x() + rays.column_part.x[u]);
			m_points.y[m_count] = rays.origin.y() + depth * (row.y() + rays.column_part.y[u]);
			m_points.z[m_count] = rays.origin.z() + depth * (row.z() + rays.column_part.z[u]);
			// Written always, counted only when in range: no branch to mispredict.
			m_count += static_cast<std::size_t>(depth > 0.0F) & static_cast<std::size_t>(depth <= max_range_m);
		}
	}
	void appendTo(PointCloud& points) const
	{
		const auto end = static_cast<std::ptrdiff_t>(m_count);
		points.x.insert(points.x.end(), m_points.x.begin(), m_points.x.begin() + end);
		points.y.insert(points.y.end(), m_points.y.begin(), m_points.y.begin() + end);
		points.z.insert(points.z.end(), m_points.z.begin(), m_points.z.begin() + end);
	}

private:
	PointCloud m_points;
	std::size_t m_count = 0;
};

PointCloud filterImage(const DepthFrame& frame, float max_range_m)
{
	const RobotRays rays(frame);
	const auto width = static_cast<std::size_t>(frame.image.intrinsics.width_px);
	const auto height = static_cast<std::size_t>(frame.image.intrinsics.height_px);
	PointCloud points_in_robot;
	points_in_robot.reserve(width * height);
	RowBuffer row(width);
	for (std::size_t v = 0; v < height; ++v)
	{
		row.fill(&frame.image.depth_m[v * width], rays, v, max_range_m);
		row.appendTo(points_in_robot);
	}
	return points_in_robot;
}

PointCloud filterCloud(const DepthFrame& frame, float max_range_m)
{
	const Eigen::Isometry3f robot_from_camera = isometryOf(frame.robot_from_camera).cast<float>();
	PointCloud points_in_robot;
	for (std::size_t i = 0; i < frame.points_in_camera.size(); ++i)
	{
		const Eigen::Vector3f point_in_camera = frame.points_in_camera[i];
		const float range_m = point_in_camera.norm();
		if (range_m > 0.0F && range_m <= max_range_m) points_in_robot.push_back(robot_from_camera * point_in_camera);
	}
	return points_in_robot;
}
}  // namespace

void describe(FieldVisitor& fields, RangeFilterConfig& config)
{
	fields.real("max_range", config.max_range_m, {0.5, 100.0}, "m",
	            "Range filter: points beyond are removed (paper: 5 m; 8 m for simulated warehouses).");
}

PointCloud rangeFilter(const DepthFrame& frame, const RangeFilterConfig& config)
{
	const auto max_range_m = static_cast<float>(config.max_range_m);
	return frame.image.empty() ? filterCloud(frame, max_range_m) : filterImage(frame, max_range_m);
}
}  // namespace explore
