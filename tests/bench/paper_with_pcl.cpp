#include "paper_with_pcl.h"

#include <pcl/ModelCoefficients.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/filters/passthrough.h>
#include <pcl/filters/project_inliers.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace explore::test
{
namespace
{
// All points are in PCL's usual camera axes: x right, y down, z forward.
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Eigen::Isometry3d robotFromOptical(const DepthFrame& frame)
{
	Eigen::Isometry3d camera_from_optical = Eigen::Isometry3d::Identity();
	camera_from_optical.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
	return isometryOf(frame.robot_from_camera) * camera_from_optical;
}

Cloud::Ptr unproject(const DepthImage& image)
{
	const CameraIntrinsics& camera = image.intrinsics;
	auto cloud = std::make_shared<Cloud>(static_cast<std::uint32_t>(camera.width_px),
	                                     static_cast<std::uint32_t>(camera.height_px));
	cloud->is_dense = false;
	const auto scale_x = static_cast<float>(1.0 / camera.fx_px), scale_y = static_cast<float>(1.0 / camera.fy_px);
	const auto cx = static_cast<float>(camera.cx_px), cy = static_cast<float>(camera.cy_px);
	std::size_t i = 0;
	for (int v = 0; v < camera.height_px; ++v)
		for (int u = 0; u < camera.width_px; ++u, ++i)
		{
			const float depth = image.depth_m[i] > 0.0F ? image.depth_m[i] : std::numeric_limits<float>::quiet_NaN();
			(*cloud)[i] = {(static_cast<float>(u) - cx) * depth * scale_x,
			               (static_cast<float>(v) - cy) * depth * scale_y, depth};
		}
	return cloud;
}

Cloud::Ptr withinRange(const Cloud::Ptr& cloud, const RangeFilterConfig& config)
{
	pcl::PassThrough<pcl::PointXYZ> filter;
	filter.setInputCloud(cloud);
	filter.setFilterFieldName("z");
	filter.setFilterLimits(0.0F, static_cast<float>(config.max_range_m));
	auto kept = std::make_shared<Cloud>();
	filter.filter(*kept);
	return kept;
}

Cloud::Ptr downsampled(const Cloud::Ptr& cloud, double leaf_m)
{
	pcl::VoxelGrid<pcl::PointXYZ> grid;
	grid.setInputCloud(cloud);
	const auto leaf = static_cast<float>(leaf_m);
	grid.setLeafSize(leaf, leaf, leaf);
	auto centroids = std::make_shared<Cloud>();
	grid.filter(*centroids);
	return centroids;
}

struct Segment
{
	pcl::ModelCoefficients::Ptr coefficients = std::make_shared<pcl::ModelCoefficients>();
	pcl::PointIndices::Ptr inliers = std::make_shared<pcl::PointIndices>();

	[[nodiscard]] Plane plane() const
	{
		const auto& c = coefficients->values;
		return {{c[0], c[1], c[2]}, c[3]};
	}
};

/** The dominant plane; with `max_tilt_rad`, among those whose normal is that near to the camera's y axis. */
Segment segment(const Cloud::Ptr& cloud, const PlaneSearchConfig& config, std::optional<double> max_tilt_rad = {})
{
	pcl::SACSegmentation<pcl::PointXYZ> search;
	search.setMethodType(pcl::SAC_RANSAC);
	search.setModelType(max_tilt_rad ? pcl::SACMODEL_PERPENDICULAR_PLANE : pcl::SACMODEL_PLANE);
	if (max_tilt_rad)
	{
		search.setAxis(Eigen::Vector3f::UnitY());
		search.setEpsAngle(*max_tilt_rad);
	}
	search.setOptimizeCoefficients(true);
	search.setDistanceThreshold(config.tolerance_m);
	search.setMaxIterations(config.max_iterations);
	search.setInputCloud(cloud);
	Segment found;
	search.segment(*found.inliers, *found.coefficients);
	if (found.inliers->indices.size() < static_cast<std::size_t>(config.min_inliers)) found.inliers->indices.clear();
	return found;
}

Cloud::Ptr projected(const Cloud::Ptr& cloud, const Segment& found)
{
	pcl::ProjectInliers<pcl::PointXYZ> projection;
	projection.setModelType(pcl::SACMODEL_PLANE);
	projection.setInputCloud(cloud);
	projection.setIndices(found.inliers);
	projection.setModelCoefficients(found.coefficients);
	auto result = std::make_shared<Cloud>();
	projection.filter(*result);
	return result;
}

Cloud::Ptr remainder(const Cloud::Ptr& cloud, const Segment& found)
{
	pcl::ExtractIndices<pcl::PointXYZ> extract;
	extract.setInputCloud(cloud);
	extract.setIndices(found.inliers);
	extract.setNegative(true);
	auto rest = std::make_shared<Cloud>();
	extract.filter(*rest);
	return rest;
}

using Gap = std::pair<Eigen::Vector3d, Eigen::Vector3d>;

std::vector<Gap> gapsAt(double height_m, const Cloud& wall, const Plane& wall_plane, const Plane& ground,
                        const DoorGapConfig& config)
{
	const Eigen::Vector3d tangent = ground.normal.cross(wall_plane.normal).normalized();
	std::vector<std::pair<double, Eigen::Vector3d>> band;
	for (const auto& point : wall)
	{
		const Eigen::Vector3d p = point.getVector3fMap().cast<double>();
		if (std::abs(ground.signedDistance(p) - height_m) <= config.scan_band_m) band.emplace_back(tangent.dot(p), p);
	}
	std::ranges::sort(band, {}, &std::pair<double, Eigen::Vector3d>::first);
	std::vector<Gap> gaps;
	for (std::size_t i = 1; i < band.size(); ++i)
	{
		const double width = (band[i].second - band[i - 1].second).norm();
		if (width >= config.min_gap_m && width <= config.max_gap_m)
			gaps.emplace_back(band[i - 1].second, band[i].second);
	}
	return gaps;
}

std::vector<Door> doorsOf(const Cloud& wall, const Plane& wall_plane, const Plane& ground, const DoorGapConfig& config)
{
	const auto low = gapsAt(config.scan_height_m, wall, wall_plane, ground, config);
	const auto high = gapsAt(config.second_scan_height_m, wall, wall_plane, ground, config);
	const auto beside = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b)
	{
		const Eigen::Vector3d offset = b - a;
		return (offset - ground.normal.dot(offset) * ground.normal).norm() <= config.agreement_m;
	};
	std::vector<Door> doors;
	for (const Gap& a : low)
		for (const Gap& b : high)
			if (beside(a.first, b.first) && beside(a.second, b.second))
			{
				Door& door = doors.emplace_back();
				door.center = 0.25 * (a.first + a.second + b.first + b.second);
				door.normal = wall_plane.normal;
				door.width_m = 0.5 * ((a.second - a.first).norm() + (b.second - b.first).norm());
				break;
			}
	return doors;
}

/** The furthest point of the wall along its line with the floor (eq. 4), on the parallel through the camera. */
Eigen::Vector3d vanishingPoint(const Cloud& wall, const Plane& wall_plane, const Plane& ground)
{
	Eigen::Matrix<double, 5, 5> system = Eigen::Matrix<double, 5, 5>::Zero();
	system.topLeftCorner<3, 3>() = 2.0 * Eigen::Matrix3d::Identity();
	system.block<3, 1>(0, 3) = wall_plane.normal;
	system.block<3, 1>(0, 4) = ground.normal;
	system.block<1, 3>(3, 0) = wall_plane.normal.transpose();
	system.block<1, 3>(4, 0) = ground.normal.transpose();
	Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
	right[3] = -wall_plane.d_m;
	right[4] = -ground.d_m;
	const Eigen::Vector3d foot = system.partialPivLu().solve(right).head<3>();
	Eigen::Vector3d direction = wall_plane.normal.cross(ground.normal).normalized();
	if (direction.z() < 0.0) direction = -direction;
	double furthest = 0.0;
	for (const auto& point : wall)
		furthest = std::max(furthest, direction.dot(point.getVector3fMap().cast<double>() - foot));
	return furthest * direction;
}

/** d(θ) as the paper has it, with the swept corridor; the robot's centre is the sensor. */
double openPath(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& direction, float radius_m,
                float max_range_m)
{
	float free = max_range_m;
	for (const Eigen::Vector3f& p : points)
	{
		const float along = p.dot(direction);
		if (along > 0.0F && (p - along * direction).squaredNorm() < radius_m * radius_m)
			free = std::min(free, std::max(0.0F, along - radius_m));
	}
	return free;
}

/** The obstacle points within ±sector of the desired direction (optical axes; azimuth is positive to the left). */
std::vector<Eigen::Vector3f> withinSector(const Cloud& obstacles, double desired_rad, double sector_rad)
{
	std::vector<Eigen::Vector3f> points;
	for (const auto& point : obstacles)
		if (std::abs(wrapToPi(std::atan2(-point.x, point.z) - desired_rad)) <= sector_rad)
			points.emplace_back(point.getVector3fMap());
	return points;
}

void avoidObstacles(PeerResult& result, const Cloud& obstacles, const ExplorerConfig& config)
{
	const double desired = result.door_rad.value_or(result.vanishing_point_rad.value_or(0.0));
	const auto points = withinSector(obstacles, desired, config.avoider.sector_rad);
	double best = -1.0;
	const int side = static_cast<int>(std::lround(config.avoider.sector_rad / config.avoider.resolution_rad));
	for (int k = -side; k <= side; ++k)
	{
		const double theta = desired + k * config.avoider.resolution_rad;
		const Eigen::Vector3f direction(static_cast<float>(-std::sin(theta)), 0.0F,
		                                static_cast<float>(std::cos(theta)));
		const double free = openPath(points, direction, static_cast<float>(config.robot.radius_m),
		                             static_cast<float>(config.avoider.max_range_m));
		if (const double worth = free * std::cos(theta - desired); worth > best)
		{
			best = worth;
			result.avoid_rad = theta;
			result.open_path_m = free;
		}
	}
}

void chooseDirections(PeerResult& result)
{
	const auto nearest = std::ranges::min_element(result.doors, {}, [](const Door& d) { return d.center.norm(); });
	if (nearest != result.doors.end()) result.door_rad = azimuthOf(nearest->center);
	if (!result.vanishing_points.empty()) result.vanishing_point_rad = azimuthOf(result.vanishing_points.front());
}
}  // namespace

PeerResult exploreWithPcl(const DepthFrame& frame, const ExplorerConfig& config, const StageEnded& ended)
{
	const auto mark = [&](std::string_view stage)
	{
		if (ended) ended(stage);
	};
	const PerceptionConfig& perception = config.perception;
	const Eigen::Isometry3d robot_from_optical = robotFromOptical(frame);
	PeerResult result;

	Cloud::Ptr cloud = unproject(frame.image);
	mark("unproject");
	cloud = withinRange(cloud, perception.range_filter);
	mark("range filter");
	const Cloud::Ptr filtered = downsampled(cloud, perception.voxel_grid.voxel_size_m);
	mark("voxel grid");

	const Segment floor = segment(filtered, perception.planes, perception.ground.max_tilt_rad);
	if (floor.inliers->indices.empty()) return result;
	result.ground_seen = true;
	const Plane ground = floor.plane().normal.y() < 0.0 ? floor.plane() : floor.plane().flipped();
	const Cloud::Ptr obstacles = remainder(filtered, floor);
	mark("ground");

	Cloud::Ptr rest = obstacles;
	while (static_cast<double>(rest->size()) > perception.planes.alpha * static_cast<double>(filtered->size()))
	{
		const Segment found = segment(rest, perception.planes);
		if (found.inliers->indices.empty()) break;
		const Plane plane = found.plane();
		if (std::abs(plane.normal.dot(ground.normal)) <= std::sin(perception.walls.max_tilt_rad))
		{
			const Cloud::Ptr wall = projected(rest, found);
			++result.walls;
			for (Door& door : doorsOf(*wall, plane, ground, perception.door_gaps))
			{
				door.center = robot_from_optical * door.center;
				door.normal = robot_from_optical.linear() * door.normal;
				result.doors.push_back(door);
			}
			result.vanishing_points.emplace_back(robot_from_optical * vanishingPoint(*wall, plane, ground));
		}
		rest = remainder(rest, found);
	}
	chooseDirections(result);
	mark("walls");

	avoidObstacles(result, *obstacles, config);
	mark("avoid");
	return result;
}
}  // namespace explore::test
