#include <explore/simulation/noise_random.h>
#include <explore/simulation/noise_speckle.h>
#include <explore/simulation/speckle_image.h>
#include <explore/simulation/speckle_match.h>
#include <explore/simulation/speckle_pattern.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace explore::simulation
{
namespace
{
constexpr double kLeastFocalLength_px = 530.0;  ///< pictures of less are matched in a finer one, as devices do
constexpr double kUsualSpread_px = 0.052;       ///< of the matched disparities of plain walls 1–4 m away
constexpr float kBlock_px = 9.0F;
constexpr double kNearer = 0.7;  ///< of the least range: what stands there is recognised and left out, not mistaken

SpeckleSearch searchFor(const DepthCameraConfig& config)
{
	// Farther than the tile is wide the pattern repeats itself.
	constexpr int kMost_px = SpecklePattern::kColumns_px - 16;
	const double focal_baseline = config.intrinsics.fx_px * config.baseline_m;
	SpeckleSearch search;
	search.width_px = config.intrinsics.width_px;
	search.height_px = config.intrinsics.height_px;
	search.most_px =
	    static_cast<int>(std::clamp(std::ceil(focal_baseline / (kNearer * config.min_range_m)), 2.0, 1.0 * kMost_px));
	search.least_px =
	    static_cast<int>(std::clamp(std::floor(focal_baseline / config.max_range_m) - 1.0, 0.0, search.most_px - 2.0));
	search.threads = config.threads;
	return search;
}

/** What a worse device adds to the matcher's own errors, which hardly grow with the noise of the picture: so much that
 *  the disparities of a plain wall spread `noise_scale` times as wide as usual. Half of it is common to the pixels of a
 *  block, for the windows of neighbours overlap. */
void spreadDisparities(std::vector<float>& disparities, const DepthCameraConfig& config, std::uint64_t seed)
{
	const double more = config.noise_scale * config.noise_scale - 1.0;
	if (more <= 0.0) return;
	const int width = config.intrinsics.width_px;
	const auto sigma_px = static_cast<float>(kUsualSpread_px * std::sqrt(0.5 * more));
	const NoiseKey blocks = noiseKey(seed, 22), pixels = noiseKey(seed, 23);
	std::vector<float> gauss(disparities.size());
	fillGaussian(pixels, 0, gauss);
	for (std::size_t i = 0; i < disparities.size(); ++i)
	{
		if (disparities[i] <= 0.0F) continue;
		const auto pixel = static_cast<int>(i);
		const float uniform = noiseOfBlob(blocks, pixel % width, pixel / width, kBlock_px) - 0.5F;
		disparities[i] = std::max(disparities[i] + sigma_px * (gauss[i] + std::sqrt(12.0F) * uniform), 1e-3F);
	}
}
}  // namespace

SpeckleCamera speckleCamera(const DepthCameraConfig& config)
{
	SpeckleCamera camera{config,
	                     std::max(1, static_cast<int>(std::ceil(kLeastFocalLength_px / config.intrinsics.fx_px)))};
	CameraIntrinsics& fine = camera.config.intrinsics;
	fine.width_px *= camera.finer;
	fine.height_px *= camera.finer;
	for (double* value : {&fine.fx_px, &fine.fy_px, &fine.cx_px, &fine.cy_px}) *value *= camera.finer;
	camera.config.disparity_step_px *= camera.finer;
	return camera;
}

std::vector<float> speckleDepth(const SensorView& view, const DepthCameraConfig& config, std::uint64_t seed)
{
	std::vector<float> values = matchSpeckles(infraredImage(view, config, seed), searchFor(config));
	spreadDisparities(values, config, seed);
	const double focal_baseline = config.intrinsics.fx_px * config.baseline_m, step_px = config.disparity_step_px;
	for (float& value : values)
	{
		if (value <= 0.0F) continue;
		const double steps = std::max(1.0, std::round(static_cast<double>(value) / step_px));
		const double depth_m = focal_baseline / (steps * step_px);
		value = depth_m >= config.min_range_m && depth_m <= config.max_range_m ? static_cast<float>(depth_m) : 0.0F;
	}
	return values;
}
}  // namespace explore::simulation
