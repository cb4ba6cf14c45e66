// One depth image as a camera measured it, before anything is corrected, with its colour image where that was asked
// for, and the observation that keeps both.
#pragma once

#include <explore/core/depth_frame.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace explore::openni2
{
/** One frame that is not what the stream said it would be. */
struct BadFrame : std::runtime_error
{
	using std::runtime_error::runtime_error;
};

/** Of a camera, whole angles. */
struct FieldOfView
{
	double horizontal_rad = 0, vertical_rad = 0;
};

using Rgb = std::array<std::uint8_t, 3>;

struct ColorImage
{
	CameraIntrinsics intrinsics;
	std::vector<Rgb> pixels;  ///< row-major, not mirrored
};

struct RawDepth
{
	CameraIntrinsics intrinsics;
	float unit_m = 0.001F;             ///< of a count
	std::vector<std::uint16_t> depth;  ///< along the optical axis, row-major, not mirrored; 0 = no return
	std::uint64_t device_time_us = 0;  ///< by the camera's clock, whose zero is its own
	mrpt::Clock::time_point arrived;   ///< by this machine's clock
	int connection = 0;                ///< grows whenever the camera was opened anew: its clock may have begun anew too
	std::optional<ColorImage> color;   ///< the latest one when the depth came, where colour is asked for
};

/** Turns each row of a row-major image round: what a mirror shows becomes what is there. */
template <class Pixel>
void unmirror(std::vector<Pixel>& image, int width_px)
{
	for (auto row = image.begin(); image.end() - row >= width_px; row += width_px) std::reverse(row, row + width_px);
}

/** What stays the same from frame to frame. */
struct ScanHeader
{
	std::string sensor_label;
	mrpt::poses::CPose3D robot_from_camera;
};

/** Counts and unit as they were measured, so that nothing is lost. The colour camera is taken to sit where the depth
 *  camera does: with registration it is so, without nothing tells how far beside it sits (a Carmine's 2.5 cm). */
mrpt::obs::CObservation3DRangeScan scanOf(const RawDepth& raw, mrpt::Clock::time_point time, const ScanHeader& header);
}  // namespace explore::openni2
