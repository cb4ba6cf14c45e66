#include "apps/rawlog_maker.h"

#include "support/analytic_scene.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>

namespace explore::test
{
namespace
{
constexpr float kUnit_m = 0.001F;

mrpt::obs::CObservation3DRangeScan scanOf(const DepthFrame& frame, mrpt::Clock::time_point time)
{
	const auto& intrinsics = frame.image.intrinsics;
	mrpt::obs::CObservation3DRangeScan scan;
	scan.timestamp = time;
	scan.sensorLabel = "TEST";
	scan.hasRangeImage = true;
	scan.range_is_depth = true;
	scan.rangeUnits = kUnit_m;
	scan.maxRange = 10.0F;
	scan.rangeImage_setSize(intrinsics.height_px, intrinsics.width_px);
	for (int v = 0; v < intrinsics.height_px; ++v)
		for (int u = 0; u < intrinsics.width_px; ++u)
			scan.rangeImage(v, u) = static_cast<std::uint16_t>(std::lround(frame.image.at(u, v) / kUnit_m));
	scan.cameraParams.ncols = static_cast<std::uint32_t>(intrinsics.width_px);
	scan.cameraParams.nrows = static_cast<std::uint32_t>(intrinsics.height_px);
	scan.cameraParams.setIntrinsicParamsFromValues(intrinsics.fx_px, intrinsics.fy_px, intrinsics.cx_px,
	                                               intrinsics.cy_px);
	return scan;
}

mrpt::obs::CObservationOdometry odometryAt(const mrpt::poses::CPose2D& pose, mrpt::Clock::time_point time)
{
	mrpt::obs::CObservationOdometry odometry;
	odometry.timestamp = time;
	odometry.sensorLabel = "ODOMETRY";
	odometry.odometry = pose;
	return odometry;
}
}  // namespace

void writeCorridorRawlog(const std::filesystem::path& path, const RawlogShape& shape)
{
	const Scene scene = corridorScene(12.0, {2.0}, {});
	const mrpt::poses::CPose3D mount(0, 0, shape.camera_height_m, 0, shape.camera_pitch_rad, 0);
	mrpt::io::CFileGZOutputStream file(path.string(), mrpt::io::OpenMode::TRUNCATE, 1);
	auto archive = mrpt::serialization::archiveFrom(file);
	for (std::size_t i = 0; i < shape.frames; ++i)
	{
		const double x_m = 0.05 * static_cast<double>(i % 100);
		const auto time = mrpt::Clock::fromDouble(1'500'000'000.0 + 0.1 * static_cast<double>(i));
		const auto frame =
		    renderFrame(scene, mrpt::poses::CPose3D(x_m, 0, 0, 0, 0, 0), mount, xtionIntrinsics(160, 120));
		auto scan = scanOf(frame, time);
		scan.sensorPose = shape.record_mount ? mount : mrpt::poses::CPose3D();
		if (shape.change) shape.change(i, scan);
		archive << odometryAt(mrpt::poses::CPose2D(x_m, 0, 0), time) << scan;
	}
}

void writeRawlog(const std::filesystem::path& path, const std::vector<DepthFrame>& frames)
{
	mrpt::io::CFileGZOutputStream file(path.string(), mrpt::io::OpenMode::TRUNCATE, 1);
	auto archive = mrpt::serialization::archiveFrom(file);
	for (const DepthFrame& frame : frames)
	{
		auto scan = scanOf(frame, frame.timestamp);
		scan.sensorPose = frame.robot_from_camera;
		archive << odometryAt(mrpt::poses::CPose2D(frame.map_from_robot), frame.timestamp) << scan;
	}
}
}  // namespace explore::test
