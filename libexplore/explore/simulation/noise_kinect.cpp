#include <explore/core/vector_code.h>
#include <explore/simulation/noise_kinect.h>
#include <explore/simulation/noise_random.h>
#include <explore/simulation/noise_samples.h>
#include <explore/simulation/parallel_rows.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace explore::simulation
{
namespace
{
constexpr float kSteep_rad = 60.0F / 90.0F * kHalfPi;  ///< from here the incidence adds to the axial noise

/** The quantities that the inner loops need, as floats. */
struct Optics
{
	explicit Optics(const DepthCameraConfig& config)
	    : focal_baseline(static_cast<float>(config.intrinsics.fx_px * config.baseline_m)),
	      step_px(static_cast<float>(config.disparity_step_px)),
	      scale(static_cast<float>(config.noise_scale)),
	      lateral_px(static_cast<float>(config.noise_scale * config.lateral_noise_px)),
	      min_m(static_cast<float>(config.min_range_m)),
	      max_m(static_cast<float>(config.max_range_m))
	{
	}
	float focal_baseline, step_px, scale, lateral_px, min_m, max_m;
};

/** Within 7e-5 rad (Abramowitz and Stegun 4.4.45). */
[[gnu::always_inline]] inline float fastArcCosine(float x)
{
	return std::sqrt(1.0F - x) * (1.5707288F + x * (-0.2121144F + x * (0.0742610F - x * 0.0187293F)));
}

/** To the nearest whole number, for |x| < 2²². */
[[gnu::always_inline]] inline float rounded(float x)
{
	constexpr float kShift = 12582912.0F;
	return (x + kShift) - kShift;
}

/** Nguyen's sigma of the depth [m]. */
[[gnu::always_inline]] inline float axialSigma(float z, float cosine)
{
	const float theta = std::min(fastArcCosine(cosine), kSteepest_rad), rest = kHalfPi - theta;
	const float steep = theta > kSteep_rad ? 0.0001F * theta * theta / (std::sqrt(z) * rest * rest) : 0.0F;
	return 0.0012F + 0.0019F * (z - 0.4F) * (z - 0.4F) + steep;
}

/** From the disparities and incidences that the pixels of a row look at, and a standard normal number each. */
[[gnu::always_inline]] inline void measure(const Optics& optics, std::size_t width, const float* disparity,
                                           const float* cosine, const float* gauss, float* depth)
{
	const Optics o = optics;
	for (std::size_t u = 0; u < width; ++u)
	{
		const float z = o.focal_baseline / std::max(disparity[u], 1e-3F);
		const float sigma = o.scale * axialSigma(z, std::max(cosine[u], 0.0F));
		const float step_m = o.step_px * z * z / o.focal_baseline;
		const float added = std::sqrt(std::max(0.0F, sigma * sigma - step_m * step_m * (1.0F / 12.0F)));
		const float noisy = std::max(z + added * gauss[u], 1e-3F);
		const float steps = rounded(std::min(o.focal_baseline / (noisy * o.step_px), 1e6F));
		const float measured = o.focal_baseline / (std::max(steps, 1.0F) * o.step_px);
		const bool returns = cosine[u] > 0.0F && disparity[u] > 0.0F && measured >= o.min_m && measured <= o.max_m;
		depth[u] = returns ? measured : 0.0F;
	}
}

EXPLORE_VECTOR_CODE(measureRow, measure,
                    (const Optics& optics, std::size_t width, const float* disparity, const float* cosine,
                     const float* gauss, float* depth),
                    (optics, width, disparity, cosine, gauss, depth))

/** Where the pixels of row `v` look: the nearest whole pixel, within the image, and how far beside it. */
struct LineOfSight
{
	std::vector<std::int32_t> column, row;
	std::vector<float> beside_u, beside_v;
};

[[gnu::always_inline]] inline void shift(std::size_t width, float at, float last, bool along_row, const float* offset,
                                         float sigma, std::int32_t* pixel, float* beside)
{
	for (std::size_t u = 0; u < width; ++u)
	{
		const float where = (along_row ? static_cast<float>(static_cast<std::int32_t>(u)) : at) + sigma * offset[u];
		const float whole = std::min(std::max(rounded(where), 0.0F), last);
		pixel[u] = static_cast<std::int32_t>(whole);
		beside[u] = where - whole;
	}
}

EXPLORE_VECTOR_CODE(shiftRow, shift,
                    (std::size_t width, float at, float last, bool along_row, const float* offset, float sigma,
                     std::int32_t* pixel, float* beside),
                    (width, at, last, along_row, offset, sigma, pixel, beside))

void measureRows(const SensorView& view, const DepthCameraConfig& config, std::uint64_t seed, int first, int last,
                 std::vector<float>& depth)
{
	const Optics optics(config);
	const NoiseKey key = noiseKey(seed, 11);
	const auto width = static_cast<std::size_t>(config.intrinsics.width_px);
	const auto last_u = static_cast<float>(width - 1);
	const auto last_v = static_cast<float>(config.intrinsics.height_px - 1);
	SampleWindow window(view, config, seed);
	std::vector<float> gauss(3 * width), disparity(width), cosine(width);
	LineOfSight sight{std::vector<std::int32_t>(width), std::vector<std::int32_t>(width), std::vector<float>(width),
	                  std::vector<float>(width)};
	const auto counters_per_row = static_cast<std::uint32_t>((gauss.size() + 1) / 2);
	for (int v = first; v < last; ++v)
	{
		window.moveTo(v, first);
		fillGaussian(key, static_cast<std::uint32_t>(v) * counters_per_row, gauss);
		shiftRow(width, 0.0F, last_u, true, gauss.data(), optics.lateral_px, sight.column.data(),
		         sight.beside_u.data());
		shiftRow(width, static_cast<float>(v), last_v, false, &gauss[width], optics.lateral_px, sight.row.data(),
		         sight.beside_v.data());
		for (std::size_t u = 0; u < width; ++u)
		{
			const Sample& seen = window.at(static_cast<std::size_t>(sight.column[u]), sight.row[u]);
			cosine[u] = seen.cosine;
			disparity[u] = seen.disparity_px + sight.beside_u[u] * seen.slope_u + sight.beside_v[u] * seen.slope_v;
		}
		measureRow(optics, width, disparity.data(), cosine.data(), &gauss[2 * width],
		           &depth[static_cast<std::size_t>(v) * width]);
	}
}
}  // namespace

std::vector<float> kinectDepth(const SensorView& view, const DepthCameraConfig& config, std::uint64_t seed)
{
	constexpr int kGrain = 16;
	std::vector<float> depth(view.depth_m.size());
	parallelRows(config.intrinsics.height_px, kGrain, config.threads,
	             [&](int first, int last) { measureRows(view, config, seed, first, last, depth); });
	return depth;
}
}  // namespace explore::simulation
