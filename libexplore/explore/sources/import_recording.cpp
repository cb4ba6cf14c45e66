#include "import_recording.h"

#include <explore/core/errors.h>
#include <explore/sources/depth_png.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <algorithm>
#include <utility>

namespace explore
{
namespace
{
using mrpt::obs::CObservation3DRangeScan;
using mrpt::obs::CObservationRobotPose;

std::string sizeText(int width, int height)
{
	return std::to_string(width) + "x" + std::to_string(height);
}

void checkImage(const TimedFile& frame, const mrpt::math::CMatrix_u16& counts, const ImportConfig& config,
                std::pair<int, int>& first_size)
{
	const std::pair<int, int> size(counts.cols(), counts.rows());
	if (first_size.first == 0) first_size = size;
	if (size != first_size)
		throw InputError(frame.path.string() + ": has " + sizeText(size.first, size.second) +
		                 " pixels; all images must have the first one's " +
		                 sizeText(first_size.first, first_size.second));
	if (config.cx_px >= size.first || config.cy_px >= size.second)
		throw InputError(frame.path.string() + ": has " + sizeText(size.first, size.second) +
		                 " pixels, which do not contain the principal point (" + std::to_string(config.cx_px) + ", " +
		                 std::to_string(config.cy_px) + "); intrinsics of this image size are needed");
}

CObservation3DRangeScan scanOf(const TimedFile& frame, mrpt::math::CMatrix_u16 counts, const ImportConfig& config)
{
	CObservation3DRangeScan scan;
	scan.timestamp = frame.time;
	scan.sensorLabel = config.sensor_label;
	scan.sensorPose = config.robot_from_camera;
	scan.hasRangeImage = true;
	scan.range_is_depth = true;
	scan.rangeUnits = static_cast<float>(config.depth_scale_m);
	scan.maxRange = 65535.0F * scan.rangeUnits;
	scan.cameraParams.ncols = static_cast<std::uint32_t>(counts.cols());
	scan.cameraParams.nrows = static_cast<std::uint32_t>(counts.rows());
	scan.cameraParams.setIntrinsicParamsFromValues(config.fx_px, config.fy_px, config.cx_px, config.cy_px);
	scan.rangeImage = std::move(counts);
	return scan;
}

CObservationRobotPose observationOf(const TimedPose& timed)
{
	CObservationRobotPose observation;
	observation.timestamp = timed.time;
	observation.sensorLabel = "POSES";
	observation.pose.mean = timed.pose;
	return observation;
}
}  // namespace

std::vector<TimedPose> robotPosesOfOptical(const std::vector<TimedPose>& map_from_optical,
                                           const mrpt::poses::CPose3D& robot_from_camera)
{
	const mrpt::poses::CPose3D optical_from_robot = -(robot_from_camera + cameraFromOptical());
	std::vector<TimedPose> map_from_robot;
	map_from_robot.reserve(map_from_optical.size());
	for (const TimedPose& timed : map_from_optical)
		map_from_robot.push_back({timed.time, timed.pose + optical_from_robot});
	return map_from_robot;
}

void importRecording(const Recording& recording, const ImportConfig& config, RawlogWriter& writer)
{
	std::vector<TimedPose> poses = recording.map_from_robot;
	std::stable_sort(poses.begin(), poses.end(),
	                 [](const TimedPose& a, const TimedPose& b) { return a.time < b.time; });
	auto pose = poses.begin();
	std::pair<int, int> first_size{0, 0};
	for (const TimedFile& frame : recording.frames)
	{
		for (; pose != poses.end() && pose->time <= frame.time; ++pose) writer.write(observationOf(*pose));
		mrpt::math::CMatrix_u16 counts = readDepthPng(frame.path);
		checkImage(frame, counts, config, first_size);
		writer.write(scanOf(frame, std::move(counts), config));
	}
	for (; pose != poses.end(); ++pose) writer.write(observationOf(*pose));
}
}  // namespace explore
