#include <explore/core/errors.h>
#include <explore/simulation/depth_camera.h>
#include <explore/simulation/noise_kinect.h>
#include <explore/simulation/noise_random.h>
#include <explore/simulation/noise_speckle.h>
#include <explore/simulation/sensor_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace explore::simulation
{
namespace
{
constexpr int kDeviceWidth_px = 640;
/** Sizes of blotches without return in an image as wide as the device's. */
constexpr std::array<float, 4> kHoleSizes_px{3.0F, 6.0F, 11.0F, 20.0F};
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

std::vector<float> depthWithin(const SensorView& view, const DepthCameraConfig& config)
{
	std::vector<float> depth = view.depth_m;
	const auto nearest = static_cast<float>(config.min_range_m), farthest = static_cast<float>(config.max_range_m);
	for (std::size_t i = 0; i < depth.size(); ++i)
		if (view.lost[i] != 0 || depth[i] < nearest || depth[i] > farthest) depth[i] = 0.0F;
	return depth;
}

/** The share of the pixels that blobs of one of kHoleSizes take alone, such that those of all sizes and the single
 *  pixels together take `share`. */
float shareOfEach(double share)
{
	return static_cast<float>(1.0 - std::pow(1.0 - share, 1.0 / static_cast<double>(kHoleSizes_px.size() + 1)));
}

/** Takes away returns: in blotches of several sizes, and pixel by pixel. */
void punchHoles(std::vector<float>& depth, const DepthCameraConfig& config, std::uint64_t seed)
{
	const int width = config.intrinsics.width_px;
	const float share = shareOfEach(config.hole_share), finer = static_cast<float>(width) / kDeviceWidth_px;
	const NoiseKey pixels = noiseKey(seed, 3);
	std::array<NoiseKey, kHoleSizes_px.size()> blotches;
	for (std::size_t i = 0; i < blotches.size(); ++i) blotches[i] = noiseKey(seed, 31 + i);
	for (std::size_t i = 0; i < depth.size(); ++i)
	{
		if (depth[i] <= 0.0F) continue;
		const auto pixel = static_cast<int>(i);
		bool lost = noiseUniform(pixels, static_cast<std::uint32_t>(i)) < share;
		for (std::size_t j = 0; j < blotches.size() && !lost; ++j)
			lost = noiseOfBlob(blotches[j], pixel % width, pixel / width, std::max(1.0F, kHoleSizes_px[j] * finer)) <
			       share;
		if (lost) depth[i] = 0.0F;
	}
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
	if (name != config.name) config = depthCamera(name);
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

CameraShot takeShot(const RayScene& scene, const DepthCameraConfig& config, const Eigen::Isometry3d& map_from_camera,
                    std::uint64_t seed)
{
	const bool speckle = config.noise == NoiseModel::speckle;
	const SpeckleCamera camera = speckle ? speckleCamera(config) : SpeckleCamera{config};
	SensorView view = lookAround(scene, camera.config, map_from_camera, seed, config.noise != NoiseModel::none);
	CameraShot shot;
	shot.depth.intrinsics = config.intrinsics;
	if (config.noise == NoiseModel::none)
		shot.depth.depth_m = depthWithin(view, config);
	else if (config.noise == NoiseModel::kinect)
		shot.depth.depth_m = kinectDepth(view, config, seed);
	else
		shot.depth.depth_m = everyNth(speckleDepth(view, camera.config, seed), config.intrinsics, camera.finer, 1);
	if (config.hole_share > 0.0) punchHoles(shot.depth.depth_m, config, seed);
	shot.rgb = camera.finer > 1 ? everyNth(view.rgb, config.intrinsics, camera.finer, 3) : std::move(view.rgb);
	return shot;
}
}  // namespace explore::simulation
