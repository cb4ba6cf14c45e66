#include <explore/core/depth_counts.h>
#include <explore/simulation/log_maker.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>

namespace explore::simulation
{
namespace
{
using mrpt::obs::CObservation3DRangeScan;

mrpt::img::TCamera cameraOf(const CameraIntrinsics& intrinsics)
{
	mrpt::img::TCamera camera;
	camera.ncols = static_cast<std::uint32_t>(intrinsics.width_px);
	camera.nrows = static_cast<std::uint32_t>(intrinsics.height_px);
	camera.setIntrinsicParamsFromValues(intrinsics.fx_px, intrinsics.fy_px, intrinsics.cx_px, intrinsics.cy_px);
	return camera;
}

void addDepth(CObservation3DRangeScan& scan, const DepthImage& depth)
{
	scan.hasRangeImage = true;
	scan.range_is_depth = true;
	scan.rangeUnits = static_cast<float>(1.0 / kDepthCountsPerMetre);
	const int width = depth.intrinsics.width_px, height = depth.intrinsics.height_px;
	scan.rangeImage_setSize(height, width);
	for (int v = 0; v < height; ++v)
		for (int u = 0; u < width; ++u) scan.rangeImage(v, u) = depthCountsOf(depth.at(u, v));
}

void addColor(CObservation3DRangeScan& scan, const CameraShot& shot)
{
	const int width = shot.depth.intrinsics.width_px, height = shot.depth.intrinsics.height_px;
	scan.hasIntensityImage = true;
	scan.intensityImageChannel = CObservation3DRangeScan::CH_VISIBLE;
	scan.cameraParamsIntensity = scan.cameraParams;
	scan.intensityImage.resize(width, height, mrpt::img::CH_RGB);
	const std::uint8_t* rgb = shot.rgb.data();
	for (int v = 0; v < height; ++v)
		for (int u = 0; u < width; ++u, rgb += 3)
		{
			auto* bgr = scan.intensityImage.ptr<std::uint8_t>(static_cast<unsigned>(u), static_cast<unsigned>(v));
			std::reverse_copy(rgb, rgb + 3, bgr);
		}
}
}  // namespace

mrpt::obs::CObservation::Ptr depthObservation(const CameraShot& shot, const mrpt::poses::CPose3D& robot_from_camera,
                                              mrpt::Clock::time_point time, const std::string& sensor_label,
                                              double max_range_m)
{
	auto scan = std::make_shared<CObservation3DRangeScan>();
	scan->timestamp = time;
	scan->sensorLabel = sensor_label;
	scan->sensorPose = robot_from_camera;
	scan->maxRange = static_cast<float>(max_range_m);
	scan->cameraParams = cameraOf(shot.depth.intrinsics);
	addDepth(*scan, shot.depth);
	if (!shot.rgb.empty()) addColor(*scan, shot);
	return scan;
}

mrpt::obs::CObservation::Ptr poseObservation(const mrpt::poses::CPose3D& map_from_robot, mrpt::Clock::time_point time,
                                             const std::string& sensor_label)
{
	auto observation = std::make_shared<mrpt::obs::CObservationRobotPose>();
	observation->timestamp = time;
	observation->sensorLabel = sensor_label;
	observation->pose.mean = map_from_robot;
	return observation;
}

mrpt::obs::CObservation::Ptr odometryObservation(const mrpt::poses::CPose3D& map_from_robot,
                                                 mrpt::Clock::time_point time, const std::string& sensor_label)
{
	auto observation = std::make_shared<mrpt::obs::CObservationOdometry>();
	observation->timestamp = time;
	observation->sensorLabel = sensor_label;
	observation->odometry = mrpt::poses::CPose2D(map_from_robot);
	return observation;
}

mrpt::obs::CObservation::Ptr imuObservation(const Eigen::Vector3d& acceleration_mps2, const Eigen::Vector3d& rate_radps,
                                            mrpt::Clock::time_point time, const std::string& sensor_label)
{
	using namespace mrpt::obs;
	auto observation = std::make_shared<CObservationIMU>();
	observation->timestamp = time;
	observation->sensorLabel = sensor_label;
	observation->set(IMU_X_ACC, acceleration_mps2.x());
	observation->set(IMU_Y_ACC, acceleration_mps2.y());
	observation->set(IMU_Z_ACC, acceleration_mps2.z());
	observation->set(IMU_WX, rate_radps.x());
	observation->set(IMU_WY, rate_radps.y());
	observation->set(IMU_WZ, rate_radps.z());
	return observation;
}
}  // namespace explore::simulation
