// Writes rawlogs/corridor.rawlog: a drive down an analytic corridor with side doors, a box on the way and a door at its
// end.
#include <explore/sources/rawlog_writer.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationOdometry.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "support/analytic_scene.h"

namespace explore::test
{
namespace
{
using mrpt::poses::CPose2D;
using mrpt::poses::CPose3D;
constexpr int kFrames = 60;
constexpr double kStep_m = 0.12;
const CPose3D kRobotFromCamera(0.10, 0.0, 0.50, 0, 0, 0);

/** 11 m long; the end wall has a door; a pedestrian-sized box stands on the right. */
Scene scene()
{
	constexpr double kLength_m = 11.0;
	Scene corridor;
	corridor.floor(-2.0, -4.0, kLength_m + 3.0, 4.0);
	corridor.wall({-2.0, 1.0}, {kLength_m, 1.0}, 2.5, {{5.0, 0.9, 2.0}, {9.5, 1.0, 2.0}});
	corridor.wall({-2.0, -1.0}, {kLength_m, -1.0}, 2.5, {{7.0, 0.9, 2.0}});
	corridor.wall({kLength_m, -4.0}, {kLength_m, 4.0}, 2.5, {{3.5, 1.0, 2.0}});
	for (const double outer : {-4.0, 4.0}) corridor.wall({-2.0, outer}, {kLength_m + 3.0, outer}, 2.5);
	corridor.wall({kLength_m + 3.0, -4.0}, {kLength_m + 3.0, 4.0}, 2.5);
	return corridor.box({6.2, -0.65, 0.85}, {0.4, 0.5, 1.7});
}

/** Down the middle, weaving a little, and to the left of the box. */
CPose2D poseOf(int index)
{
	const double x = kStep_m * index;
	const auto y = [](double at) { return 0.25 * std::exp(-std::pow((at - 6.2) / 1.2, 2)) + 0.05 * std::sin(at); };
	return {x, y(x), std::atan2(y(x + 0.05) - y(x - 0.05), 0.1)};
}

/** A Kinect measures disparity in steps of 1/8 px: z = fB/d with f = 588 px at VGA, B = 0.075 m. */
double quantised(double depth_m)
{
	constexpr double kFocalTimesBase = 588.0 * 0.075;
	return depth_m <= 0.0 ? 0.0 : kFocalTimesBase / (std::round(8.0 * kFocalTimesBase / depth_m) / 8.0);
}

mrpt::obs::CObservation3DRangeScan scanOf(const DepthFrame& frame)
{
	const CameraIntrinsics& camera = frame.image.intrinsics;
	mrpt::obs::CObservation3DRangeScan scan;
	scan.timestamp = frame.timestamp;
	scan.sensorLabel = "KINECT";
	scan.sensorPose = frame.robot_from_camera;
	scan.cameraParams.ncols = static_cast<std::uint32_t>(camera.width_px);
	scan.cameraParams.nrows = static_cast<std::uint32_t>(camera.height_px);
	scan.cameraParams.setIntrinsicParamsFromValues(camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px);
	scan.hasRangeImage = true;
	scan.range_is_depth = true;
	scan.rangeUnits = 0.001F;
	scan.rangeImage_setSize(camera.height_px, camera.width_px);
	for (int v = 0; v < camera.height_px; ++v)
		for (int u = 0; u < camera.width_px; ++u)
			scan.rangeImage(v, u) = static_cast<std::uint16_t>(std::lround(1000.0 * quantised(frame.image.at(u, v))));
	return scan;
}

void record(const std::filesystem::path& path)
{
	const Scene corridor = scene();
	RawlogWriter writer(path);
	for (int i = 0; i < kFrames; ++i)
	{
		DepthFrame frame = renderFrame(corridor, CPose3D(poseOf(i)), kRobotFromCamera, xtionIntrinsics(320, 240),
		                               {.axial_scale = 1.0,
		                                .dropout_share = 0.02,
		                                .max_depth_m = 8.0,
		                                .min_depth_m = 0.5,
		                                .seed = static_cast<std::uint32_t>(i + 1)});
		frame.timestamp += std::chrono::milliseconds(240 * i);

		mrpt::obs::CObservationOdometry odometry;
		odometry.timestamp = frame.timestamp;
		odometry.sensorLabel = "ODOMETRY";
		odometry.odometry = poseOf(i);
		writer.write(odometry);
		writer.write(scanOf(frame));
	}
	writer.close();
}
}  // namespace
}  // namespace explore::test

int main(int argc, char** argv)
try
{
	if (argc != 2)
	{
		std::cerr << "usage: record_corridor OUT.rawlog\n";
		return EXIT_FAILURE;
	}
	explore::test::record(argv[1]);
	return EXIT_SUCCESS;
}
catch (const std::exception& error)
{
	std::cerr << error.what() << '\n';
	return EXIT_FAILURE;
}
