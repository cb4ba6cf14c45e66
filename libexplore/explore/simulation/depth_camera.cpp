#include <explore/simulation/depth_camera.h>
#include <explore/simulation/noise_kinect.h>
#include <explore/simulation/noise_random.h>
#include <explore/simulation/noise_speckle.h>
#include <explore/simulation/sensor_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace explore::simulation
{
namespace
{
/** Sizes of blotches without return in an image as wide as the device's. */
constexpr std::array<float, 4> kHoleSizes_px{3.0F, 6.0F, 11.0F, 20.0F};

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
