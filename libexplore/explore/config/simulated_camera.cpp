#include <explore/config/simulated_camera.h>
#include <explore/core/errors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace explore::simulation
{
namespace
{
constexpr std::array<std::string_view, 3> kNoiseNames{"none", "kinect", "speckle"};

double focalLength(int size_px, double field_of_view_deg)
{
	return 0.5 * size_px / std::tan(field_of_view_deg * std::numbers::pi / 360.0);
}

/** All that depends on the width of the picture. */
void setWidth(DepthCameraConfig& config, int width_px)
{
	CameraIntrinsics& camera = config.intrinsics;
	camera.width_px = width_px;
	camera.height_px = std::max(1, width_px * 3 / 4);
	camera.fx_px = focalLength(camera.width_px, 57.0);
	camera.fy_px = config.name == "kinect" ? camera.fx_px : focalLength(camera.height_px, 45.0);
	camera.cx_px = 0.5 * (camera.width_px - 1);
	camera.cy_px = 0.5 * (camera.height_px - 1);
	const double scale = static_cast<double>(width_px) / kDeviceWidth_px;
	config.disparity_step_px = 0.125 * scale;
	config.lateral_noise_px = 0.5 * scale;
}
}  // namespace

std::string_view nameOf(NoiseModel noise)
{
	return kNoiseNames.at(static_cast<std::size_t>(noise));
}

DepthCameraConfig depthCamera(std::string_view name, int width_px)
{
	DepthCameraConfig config;
	config.name = name;
	if (name == "kinect")
		config.min_range_m = 0.6;
	else if (name == "ideal")
	{
		config.noise = NoiseModel::none;
		config.min_range_m = 0.05;
		config.max_range_m = 20.0;
	}
	else if (name != "xtion")
		throw ConfigError("simulated camera: \"" + std::string(name) + "\" is not one of xtion, kinect, ideal");
	setWidth(config, width_px);
	return config;
}

void describe(FieldVisitor& fields, DepthCameraConfig& config)
{
	fields.section("simulated_camera", "The depth camera in a simulated world.");
	std::string name = config.name;
	fields.text("name", name, "xtion, kinect or ideal: sets all that follows, which the keys below then change.");
	if (name != config.name) config = depthCamera(name, config.intrinsics.width_px);
	int width_px = config.intrinsics.width_px;
	fields.integer("width_px", width_px, {16, 4096}, "px",
	               "Width of the picture, three quarters of it high; sets the focal lengths, disparity_step_px and "
	               "lateral_noise_px.");
	if (width_px != config.intrinsics.width_px) setWidth(config, width_px);
	CameraIntrinsics& camera = config.intrinsics;
	fields.integer("height_px", camera.height_px, {12, 4096}, "px", "Height of the picture.");
	fields.real("fx_px", camera.fx_px, {4, 1e5}, "px", "Focal length across.");
	fields.real("fy_px", camera.fy_px, {4, 1e5}, "px", "Focal length along the columns.");
	fields.real("cx_px", camera.cx_px, {-1e4, 1e4}, "px", "Column of the optical axis; the first one is 0.");
	fields.real("cy_px", camera.cy_px, {-1e4, 1e4}, "px", "Row of the optical axis; the first one is 0.");
	fields.real("min_range", config.min_range_m, {0.01, 10}, "m", "Nothing nearer along the optical axis is measured.");
	fields.real("max_range", config.max_range_m, {0.1, 100}, "m",
	            "Nothing farther along the optical axis is measured.");
	fields.real("rate", config.rate_hz, {0.1, 1000}, "Hz", "Frames a second.");
	fields.choice("noise", config.noise, kNoiseNames,
	              "none: exact; kinect: formulas of Nguyen 2012; speckle: a projected pattern matched block by block.");
	fields.real("baseline", config.baseline_m, {0.005, 1}, "m", "From the camera to the projector, on its right.");
	fields.real("disparity_step_px", config.disparity_step_px, {0.001, 4}, "px", "Disparities are rounded to this.");
	fields.real("noise_scale", config.noise_scale, {0, 10}, "",
	            "Factor on the noise of the depth: axial and lateral (kinect), of the disparities (speckle).");
	fields.real("lateral_noise_px", config.lateral_noise_px, {0, 4}, "px",
	            "Standard deviation of the place that a pixel looks at; with noise = kinect.");
	fields.real("edge_dropout", config.edge_dropout, {0, 1}, "",
	            "Share of the pixels along depth edges without a return; with noise = kinect.");
	fields.real("hole_share", config.hole_share, {0, 1}, "",
	            "Share of further pixels without a return: blotches of several sizes and single pixels.");
	fields.real("glass_dropout", config.glass_dropout, {0.2, 1}, "",
	            "Share of a pane's pixels without a return at normal incidence; more where it is seen at an angle.");
	fields.flag("color", config.color, "Render a flat-shaded colour picture too.");
	fields.integer("threads", config.threads, {1, 256}, "", "Processor threads; the picture does not depend on them.");
}
}  // namespace explore::simulation
