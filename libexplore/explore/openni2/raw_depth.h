// One depth image as a camera measured it, before anything is corrected, and the observation that keeps it.
#pragma once

#include <explore/core/depth_frame.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <cstdint>
#include <string>
#include <vector>

namespace explore::openni2
{
struct RawDepth
{
	CameraIntrinsics intrinsics;
	float unit_m = 0.001F;             ///< of a count
	std::vector<std::uint16_t> depth;  ///< along the optical axis, row-major, not mirrored; 0 = no return
	std::uint64_t device_time_us = 0;  ///< by the camera's clock, whose zero is its own
	mrpt::Clock::time_point arrived;   ///< by this machine's clock
	int connection = 0;                ///< grows whenever the camera was opened anew: its clock may have begun anew too
};

/** Turns each row of a row-major image round: what a mirror shows becomes what is there. */
void unmirror(std::vector<std::uint16_t>& depth, int width_px);

/** What stays the same from frame to frame. */
struct ScanHeader
{
	std::string sensor_label;
	mrpt::poses::CPose3D robot_from_camera;
};

/** Counts and unit as they were measured, so that nothing is lost. */
mrpt::obs::CObservation3DRangeScan scanOf(const RawDepth& raw, mrpt::Clock::time_point time, const ScanHeader& header);
}  // namespace explore::openni2
