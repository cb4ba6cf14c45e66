#include "depth_conversion.h"

#include <explore/sources/external_files.h>
#include <explore/sources/pose_track.h>
#include <explore/sources/unusable_frame.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace explore
{
namespace
{
using mrpt::obs::CObservation;
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationVelodyneScan;

/** Points farther than this come from damage, not from a sensor. */
constexpr float kFarthest_m = 1e6F;

[[noreturn]] void unusable(const std::string& what, bool is_damage = true)
{
	throw UnusableFrame(what, is_damage);
}

std::string sizeText(std::size_t width, std::size_t height)
{
	return std::to_string(width) + "x" + std::to_string(height);
}

CameraIntrinsics intrinsicsOf(const CObservation3DRangeScan& scan)
{
	const auto& camera = scan.cameraParams;
	const auto width = static_cast<std::size_t>(scan.rangeImage.cols());
	const auto height = static_cast<std::size_t>(scan.rangeImage.rows());
	if (camera.ncols != width || camera.nrows != height)
		unusable("the intrinsics are for " + sizeText(camera.ncols, camera.nrows) + " pixels, the range image has " +
		         sizeText(width, height));
	const CameraIntrinsics intrinsics{
	    static_cast<int>(width), static_cast<int>(height), camera.fx(), camera.fy(), camera.cx(), camera.cy()};
	const auto focal_ok = [](double f) { return f >= 1.0 && f <= 1e6; };
	const auto center_ok = [](double c) { return std::abs(c) <= 1e6; };
	const auto finite = [](double k) { return std::isfinite(k); };
	if (!focal_ok(intrinsics.fx_px) || !focal_ok(intrinsics.fy_px) || !center_ok(intrinsics.cx_px) ||
	    !center_ok(intrinsics.cy_px) || !std::all_of(camera.dist.begin(), camera.dist.end(), finite))
		unusable("the camera's intrinsics are not usable: fx " + std::to_string(intrinsics.fx_px) + ", fy " +
		         std::to_string(intrinsics.fy_px) + ", cx " + std::to_string(intrinsics.cx_px) + ", cy " +
		         std::to_string(intrinsics.cy_px));
	return intrinsics;
}

std::vector<float> metresOf(const CObservation3DRangeScan& scan)
{
	const float unit_m = scan.rangeUnits;
	if (!(unit_m > 0.0F && unit_m <= 1.0F))
		unusable("rangeUnits = " + std::to_string(unit_m) + "; above 0 and at most 1 m is needed");
	const auto count = static_cast<std::size_t>(scan.rangeImage.size());
	const std::uint16_t* raw = scan.rangeImage.data();
	std::vector<float> values(count);
	std::transform(raw, raw + count, values.begin(),
	               [unit_m](std::uint16_t n) { return static_cast<float>(n) * unit_m; });
	return values;
}

/** Ranges are distances from the camera's centre; depths are their share along the optical axis. */
void rangesToDepths(const CameraIntrinsics& camera, std::vector<float>& values)
{
	std::size_t i = 0;
	for (int v = 0; v < camera.height_px; ++v)
		for (int u = 0; u < camera.width_px; ++u, ++i)
			if (values[i] > 0.0F) values[i] /= static_cast<float>(rayOfPixel(camera, u, v).norm());
}

void addPoint(PointCloud& cloud, const Eigen::Vector3f& point)
{
	// Sensors mark points without a return by the origin or by NaN; both fail here.
	const float reach = point.cwiseAbs().maxCoeff();
	if (point.allFinite() && reach > 0.0F && reach < kFarthest_m) cloud.push_back(point);
}

PointCloud pointsOf(const std::vector<float>& x, const std::vector<float>& y, const std::vector<float>& z)
{
	if (y.size() != x.size() || z.size() != x.size()) unusable("the coordinates of its points do not have one length");
	PointCloud cloud;
	cloud.reserve(x.size());
	for (std::size_t i = 0; i < x.size(); ++i) addPoint(cloud, {x[i], y[i], z[i]});
	return cloud;
}

PointCloud pointsOf(const CObservationPointCloud& observation)
{
	if (!observation.pointcloud) unusable("it holds no points", false);
	PointCloud cloud;
	cloud.reserve(observation.pointcloud->size());
	for (std::size_t i = 0; i < observation.pointcloud->size(); ++i)
	{
		Eigen::Vector3f point;
		observation.pointcloud->getPoint(i, point.x(), point.y(), point.z());
		addPoint(cloud, point);
	}
	return cloud;
}

PointCloud pointsOf(CObservationVelodyneScan& scan)
{
	try
	{
		if (scan.point_cloud.x.empty()) scan.generatePointCloud();
	}
	catch (const std::exception&)
	{
		unusable("its packets cannot be turned into points");
	}
	return pointsOf(scan.point_cloud.x, scan.point_cloud.y, scan.point_cloud.z);
}
}  // namespace

bool isDepthObservation(const CObservation& observation)
{
	return dynamic_cast<const CObservation3DRangeScan*>(&observation) != nullptr ||
	       dynamic_cast<const CObservationPointCloud*>(&observation) != nullptr ||
	       dynamic_cast<const CObservationVelodyneScan*>(&observation) != nullptr;
}

float correctedDepth(const CameraConfig& camera, float depth_m)
{
	if (!(depth_m > 0.0F)) return 0.0F;
	const double z = depth_m;
	const double corrected = camera.depth_offset_m + camera.depth_scale * z + camera.depth_quadratic_per_m * z * z;
	return corrected > 0.0 && corrected < kFarthest_m ? static_cast<float>(corrected) : 0.0F;
}

DepthConverter::DepthConverter(const SourceConfig& config, std::filesystem::path images_folder)
    : m_camera(config.camera),
      m_sensor_poses(config.sensor_poses),
      m_images_folder(std::move(images_folder)),
      m_mask(config.camera.self_mask)
{
}

void DepthConverter::correct(std::vector<float>& depth_m) const
{
	if (m_camera.depth_scale == 1.0 && m_camera.depth_offset_m == 0.0 && m_camera.depth_quadratic_per_m == 0.0) return;
	for (float& depth : depth_m) depth = correctedDepth(m_camera, depth);
}

DepthImage DepthConverter::imageOf(const CObservation3DRangeScan& scan)
{
	DepthImage image{intrinsicsOf(scan), metresOf(scan)};
	m_mask.apply(image.intrinsics.width_px, image.intrinsics.height_px, image.depth_m);
	if (hasDistortion(scan.cameraParams)) m_undistorter.apply(scan.cameraParams, image.depth_m);
	if (!scan.range_is_depth) rangesToDepths(image.intrinsics, image.depth_m);
	correct(image.depth_m);
	return image;
}

PointCloud DepthConverter::cloudOf(const CObservation3DRangeScan& scan) const
{
	PointCloud measured = pointsOf(scan.points3D_x, scan.points3D_y, scan.points3D_z), corrected;
	corrected.reserve(measured.size());
	for (std::size_t i = 0; i < measured.size(); ++i)
	{
		const Eigen::Vector3f point = measured[i];
		const float depth = correctedDepth(m_camera, point.x());
		if (depth > 0.0F) addPoint(corrected, point * (depth / point.x()));
	}
	return corrected;
}

mrpt::poses::CPose3D DepthConverter::mountOf(const CObservation& observation) const
{
	if (m_camera.mount == MountPolicy::ini)
		return {m_camera.x_m, m_camera.y_m, m_camera.z_m, m_camera.yaw_rad, m_camera.pitch_rad, m_camera.roll_rad};
	const auto given = m_sensor_poses.find(observation.sensorLabel);
	if (given != m_sensor_poses.end()) return given->second;
	mrpt::poses::CPose3D robot_from_sensor;
	observation.getSensorPose(robot_from_sensor);
	if (!isSane(robot_from_sensor)) unusable("its sensorPose is not finite");
	return robot_from_sensor;
}

DepthFrame DepthConverter::convert(CObservation& observation)
{
	DepthFrame frame;
	frame.sensor_label = observation.sensorLabel;
	frame.robot_from_camera = mountOf(observation);
	loadExternalFiles(observation, m_images_folder);
	if (auto* velodyne = dynamic_cast<CObservationVelodyneScan*>(&observation))
		frame.points_in_camera = pointsOf(*velodyne);
	else if (const auto* cloud = dynamic_cast<const CObservationPointCloud*>(&observation))
		frame.points_in_camera = pointsOf(*cloud);
	else
	{
		const auto& scan = dynamic_cast<const CObservation3DRangeScan&>(observation);
		if (scan.hasRangeImage && scan.rangeImage.size() > 0)
			frame.image = imageOf(scan);
		else if (scan.hasPoints3D)
			frame.points_in_camera = cloudOf(scan);
		else
			unusable("it has neither a range image nor points", false);
	}
	return frame;
}
}  // namespace explore
