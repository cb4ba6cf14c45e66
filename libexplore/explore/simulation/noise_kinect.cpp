#include <explore/simulation/noise_kinect.h>
#include <explore/simulation/noise_random.h>
#include <explore/simulation/parallel_rows.h>
#include <explore/simulation/vector_code.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace explore::simulation
{
namespace
{
constexpr float kHalfPi = std::numbers::pi_v<float> / 2;
constexpr float kSteepest_rad = 88.0F / 90.0F * kHalfPi;  ///< beyond it the pattern is too stretched for any return
constexpr float kSteep_rad = 60.0F / 90.0F * kHalfPi;     ///< from here the incidence adds to the axial noise
constexpr float kEdgeSteps = 4.0F;                        ///< a jump of that many steps of disparity is an edge

/** What a pixel hands to those that look at it. */
struct Sample
{
	float disparity_px = 0;          ///< 0 = nothing there
	float slope_u = 0, slope_v = 0;  ///< of the disparity [px/px]; 0 at an edge
	float cosine = -1;               ///< of the incidence; −1 = gives no return
};

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

/** The gentler of two slopes of the same sign, else 0: exact on planes, and flat at edges. */
[[gnu::always_inline]] inline float gentler(float before, float after)
{
	const float size = std::min(std::abs(before), std::abs(after));
	return before * after > 0.0F ? std::copysign(size, before) : 0.0F;
}

/** The samples of a row between those above and below it; each row has one more value at
 *  either end. */
[[gnu::always_inline]] inline void sample(std::size_t width, const float* above, const float* here, const float* below,
                                          float edge_px, float* slope_u, float* slope_v, float* edge)
{
	for (std::size_t u = 0; u < width; ++u)
	{
		const float d = here[u + 1];
		const float left = d - here[u], right = here[u + 2] - d, up = d - above[u + 1], down = below[u + 1] - d;
		slope_u[u] = gentler(left, right);
		slope_v[u] = gentler(up, down);
		edge[u] = std::max(std::abs(right - left), std::abs(down - up)) > edge_px ? 1.0F : 0.0F;
	}
}

EXPLORE_VECTOR_CODE(sampleRow, sample,
                    (std::size_t width, const float* above, const float* here, const float* below, float edge_px,
                     float* slope_u, float* slope_v, float* edge),
                    (width, above, here, below, edge_px, slope_u, slope_v, edge))

/** Samples of the rows around the one that is measured: a ring, so that they stay in the cache. */
class SampleWindow
{
public:
	SampleWindow(const SensorView& view, const DepthCameraConfig& config, std::uint64_t seed)
	    : m_view(view),
	      m_optics(config),
	      m_edge_dropout(static_cast<float>(config.edge_dropout)),
	      m_edge_key(noiseKey(seed, 12)),
	      m_width(static_cast<std::size_t>(config.intrinsics.width_px)),
	      m_height(config.intrinsics.height_px),
	      m_reach(std::min(m_height, static_cast<int>(std::ceil(kFarthestSigma * m_optics.lateral_px + 0.5F)))),
	      m_ring(m_width * static_cast<std::size_t>(2 * m_reach + 1)),
	      m_slope_u(m_width),
	      m_slope_v(m_width),
	      m_edge(m_width)
	{
	}

	/** Makes the samples around row `v`; rows come in order from `first`. */
	void moveTo(int v, int first);
	[[nodiscard]] const Sample& at(std::size_t u, int v) const { return m_ring[ringRow(v) + u]; }

private:
	static constexpr float kFarthestSigma = 5.9F;  ///< of a Gaussian number

	[[nodiscard]] std::size_t ringRow(int v) const { return static_cast<std::size_t>(v % (2 * m_reach + 1)) * m_width; }
	/** The disparities of row `v`, which goes on straight for one pixel beyond both ends, as do the rows. */
	void disparities(int v, std::vector<float>& padded) const;
	void sampleOne(int v);

	const SensorView& m_view;
	Optics m_optics;
	float m_edge_dropout;
	NoiseKey m_edge_key;
	std::size_t m_width;
	int m_height, m_reach, m_next = -1;  ///< the next row to sample; −1 before the first
	std::vector<Sample> m_ring;
	std::vector<float> m_above, m_here, m_below, m_slope_u, m_slope_v, m_edge;
};

void SampleWindow::disparities(int v, std::vector<float>& padded) const
{
	padded.resize(m_width + 2);
	if ((v < 0 || v >= m_height) && m_height > 1)
	{
		std::vector<float> inner;
		disparities(v < 0 ? 0 : m_height - 1, padded);
		disparities(v < 0 ? 1 : m_height - 2, inner);
		for (std::size_t i = 0; i < padded.size(); ++i)
			if (padded[i] > 0.0F && inner[i] > 0.0F) padded[i] += padded[i] - inner[i];
		return;
	}
	const float* depth = &m_view.depth_m[static_cast<std::size_t>(std::clamp(v, 0, m_height - 1)) * m_width];
	for (std::size_t u = 0; u < m_width; ++u)
		padded[u + 1] = depth[u] > 0.0F ? m_optics.focal_baseline / depth[u] : 0.0F;
	const auto beyond = [](float last, float before)
	{ return last > 0.0F && before > 0.0F ? 2.0F * last - before : last; };
	padded.front() = beyond(padded[1], padded[std::min<std::size_t>(2, m_width)]);
	padded.back() = beyond(padded[m_width], padded[std::max<std::size_t>(1, m_width - 1)]);
}

void SampleWindow::sampleOne(int v)
{
	static const float kLeastCosine = std::cos(kSteepest_rad);
	disparities(v + 1, m_below);
	sampleRow(m_width, m_above.data(), m_here.data(), m_below.data(), kEdgeSteps * m_optics.step_px, m_slope_u.data(),
	          m_slope_v.data(), m_edge.data());
	const std::size_t first = static_cast<std::size_t>(v) * m_width;
	Sample* samples = &m_ring[ringRow(v)];
	for (std::size_t u = 0; u < m_width; ++u)
	{
		const float cosine = m_view.cosine[first + u];
		bool returns = m_view.lost[first + u] == 0 && cosine > kLeastCosine;
		if (m_edge[u] > 0.0F && noiseUniform(m_edge_key, static_cast<std::uint32_t>(first + u)) < m_edge_dropout)
			returns = false;
		samples[u] = {m_here[u + 1], m_slope_u[u], m_slope_v[u], returns ? cosine : -1.0F};
	}
	m_above.swap(m_here);
	m_here.swap(m_below);
}

void SampleWindow::moveTo(int v, int first)
{
	if (m_next < 0)
	{
		m_next = std::max(0, first - m_reach);
		disparities(m_next - 1, m_above);
		disparities(m_next, m_here);
	}
	for (; m_next <= std::min(v + m_reach, m_height - 1); ++m_next) sampleOne(m_next);
}

void measureRows(const SensorView& view, const DepthCameraConfig& config, std::uint64_t seed, int first, int last,
                 std::vector<float>& depth)
{
	const Optics optics(config);
	const NoiseKey key = noiseKey(seed, 11);
	const auto width = static_cast<std::size_t>(config.intrinsics.width_px);
	const float last_u = static_cast<float>(width - 1), last_v = static_cast<float>(config.intrinsics.height_px - 1);
	SampleWindow window(view, config, seed);
	std::vector<float> gauss(3 * width), disparity(width), cosine(width);
	const auto counters_per_row = static_cast<std::uint32_t>((gauss.size() + 1) / 2);
	for (int v = first; v < last; ++v)
	{
		window.moveTo(v, first);
		fillGaussian(key, static_cast<std::uint32_t>(v) * counters_per_row, gauss);
		for (std::size_t u = 0; u < width; ++u)
		{
			const float at_u = static_cast<float>(u) + optics.lateral_px * gauss[u];
			const float at_v = static_cast<float>(v) + optics.lateral_px * gauss[width + u];
			const float column = std::clamp(rounded(at_u), 0.0F, last_u), row = std::clamp(rounded(at_v), 0.0F, last_v);
			const Sample& seen = window.at(static_cast<std::size_t>(static_cast<int>(column)), static_cast<int>(row));
			cosine[u] = seen.cosine;
			disparity[u] = seen.disparity_px + (at_u - column) * seen.slope_u + (at_v - row) * seen.slope_v;
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
