// [simulated_camera]: which depth camera a simulated world is seen through.
#pragma once

#include <explore/config/fields.h>
#include <explore/core/depth_frame.h>

#include <string>
#include <string_view>

namespace explore::simulation
{
/** Width of the picture in which the devices match disparities. */
inline constexpr int kDeviceWidth_px = 640;

enum class NoiseModel
{
	none,     ///< exact depth within the range, of every surface that returns light
	kinect,   ///< axial, lateral, disparity steps, edge dropout, projector shadow (Nguyen 2012)
	speckle,  ///< a projected speckle pattern, rendered and matched block by block
};

[[nodiscard]] std::string_view nameOf(NoiseModel noise);

struct DepthCameraConfig
{
	std::string name = "xtion";
	CameraIntrinsics intrinsics;
	double min_range_m = 0.5, max_range_m = 8.0;
	double rate_hz = 10.0;
	double baseline_m = 0.075;  ///< the projector is that far to the right of the camera: shadows fall to the left
	double disparity_step_px = 0.125;  ///< sub-pixel resolution of the matcher, in pixels of this image
	NoiseModel noise = NoiseModel::kinect;
	double noise_scale = 1.0;       ///< factor on the noise of the depth, whatever the model
	double lateral_noise_px = 0.5;  ///< sigma of the shift of a pixel's line of sight, in pixels of this image
	double edge_dropout = 0.5;      ///< share of the pixels along depth edges that lose their return
	double hole_share = 0.0;        ///< further pixels that lose their return, in blotches and one by one, 0–1
	double glass_dropout = 0.4;     ///< share of a pane's pixels without a return at normal incidence, at least 0.2
	bool color = false;             ///< render a flat-shaded picture too
	int threads = 1;
};

/** The camera called "xtion", "kinect" or "ideal", `width_px` × ¾ `width_px`. The devices match disparities in a VGA
 *  image: in a smaller picture their steps and shifts are as much smaller in pixels, and the same in metres. Throws
 *  ConfigError for another name. */
DepthCameraConfig depthCamera(std::string_view name, int width_px = kDeviceWidth_px);

/** [simulated_camera]. The name comes first: another name than before, and then another width, fill in the values of
 *  that camera, which the keys after them change. A name alone keeps the width. */
void describe(FieldVisitor& fields, DepthCameraConfig& config);
}  // namespace explore::simulation
