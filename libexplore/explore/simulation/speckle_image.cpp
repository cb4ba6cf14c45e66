#include <explore/simulation/noise_random.h>
#include <explore/simulation/parallel_rows.h>
#include <explore/simulation/speckle_image.h>
#include <explore/simulation/speckle_pattern.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace explore::simulation
{
namespace
{
constexpr float kAmbient = 24.0F;          ///< counts without the projector
constexpr float kDotAtOneMetre = 1400.0F;  ///< counts of a full dot on a white surface seen frontally
constexpr float kBrightest = 1023.0F;      ///< a converter of ten bits
constexpr float kReadNoise = 1.6F;         ///< counts
constexpr float kShotNoise = 0.35F;        ///< variance a count
constexpr float kDarkestInfrared = 0.25F;  ///< what is dark to the eye still returns infrared light

/** Counts at pixel (u, v), without noise. */
float countsAt(const SensorView& view, std::size_t pixel, float focal_baseline, int u, int v)
{
	const float z = view.depth_m[pixel];
	if (!(z > 0.0F) || view.lost[pixel] != 0) return kAmbient;
	const float reflectance =
	    kDarkestInfrared + (1.0F - kDarkestInfrared) * std::clamp(view.reflectance[pixel], 0.0F, 1.0F);
	const float dot = specklePattern().brightness(static_cast<float>(u) - focal_baseline / z, v);
	return kAmbient + kDotAtOneMetre * reflectance * view.cosine[pixel] * dot / (z * z);
}
}  // namespace

std::vector<std::uint16_t> infraredImage(const SensorView& view, const DepthCameraConfig& config, std::uint64_t seed)
{
	const int width = config.intrinsics.width_px;
	const auto focal_baseline = static_cast<float>(config.intrinsics.fx_px * config.baseline_m);
	const auto scale = static_cast<float>(config.noise_scale);
	const NoiseKey key = noiseKey(seed, 21);
	std::vector<std::uint16_t> image(view.depth_m.size());
	const auto render_rows = [&](int first, int last)
	{
		std::vector<float> gauss(static_cast<std::size_t>(width));
		for (int v = first; v < last; ++v)
		{
			const std::size_t start = static_cast<std::size_t>(v) * gauss.size();
			fillGaussian(key, static_cast<std::uint32_t>(start), gauss);
			for (int u = 0; u < width; ++u)
			{
				const auto column = static_cast<std::size_t>(u);
				const float counts = countsAt(view, start + column, focal_baseline, u, v);
				const float sigma = scale * std::sqrt(kReadNoise * kReadNoise + kShotNoise * counts);
				image[start + column] = static_cast<std::uint16_t>(
				    std::floor(std::clamp(counts + sigma * gauss[column], 0.0F, kBrightest) + 0.5F));
			}
		}
	};
	parallelRows(config.intrinsics.height_px, 16, config.threads, render_rows);
	return image;
}
}  // namespace explore::simulation
