// Small rawlogs of an analytic corridor, written with MRPT alone.
#pragma once

#include <explore/core/depth_frame.h>

#include <filesystem>
#include <functional>
#include <vector>

namespace mrpt::obs
{
class CObservation3DRangeScan;
}

namespace explore::test
{
struct RawlogShape
{
	std::size_t frames = 5;
	/** Changes a scan before it is written; gets the frame's number. */
	std::function<void(std::size_t, mrpt::obs::CObservation3DRangeScan&)> change = {};
	double camera_height_m = 0.5, camera_pitch_rad = 0.0;
	bool record_mount = true;  ///< false: an identity sensorPose, wherever the camera really is
};

/** A robot drives 0.05 m a frame (0.1 s) along a corridor of 2 m width with a door on the left: odometry and 160 × 120
 *  depth frames, gzipped. */
void writeCorridorRawlog(const std::filesystem::path& path, const RawlogShape& shape = {});

/** These frames with their times and mounts, and odometry from their poses; gzipped. */
void writeRawlog(const std::filesystem::path& path, const std::vector<DepthFrame>& frames);
}  // namespace explore::test
