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
