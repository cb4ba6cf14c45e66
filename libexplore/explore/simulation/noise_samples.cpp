#include <explore/core/vector_code.h>
#include <explore/simulation/noise_samples.h>

#include <algorithm>
#include <cmath>

namespace explore::simulation
{
namespace
{
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

}  // namespace

/** Rows away that a pixel may look at. */
int SampleWindow::reachOf(const DepthCameraConfig& config)
{
	constexpr double kFarthestSigma = 5.9;  // of a Gaussian number
	const double farthest_px = kFarthestSigma * config.noise_scale * config.lateral_noise_px + 0.5;
	return static_cast<int>(std::min(std::ceil(farthest_px), 1.0 * config.intrinsics.height_px));
}

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
	for (std::size_t u = 0; u < m_width; ++u) padded[u + 1] = depth[u] > 0.0F ? m_focal_baseline / depth[u] : 0.0F;
	const auto beyond = [](float last, float before)
	{ return last > 0.0F && before > 0.0F ? 2.0F * last - before : last; };
	padded.front() = beyond(padded[1], padded[std::min<std::size_t>(2, m_width)]);
	padded.back() = beyond(padded[m_width], padded[std::max<std::size_t>(1, m_width - 1)]);
}

void SampleWindow::sampleOne(int v)
{
	static const float kLeastCosine = std::cos(kSteepest_rad);
	disparities(v + 1, m_below);
	sampleRow(m_width, m_above.data(), m_here.data(), m_below.data(), m_edge_px, m_slope_u.data(), m_slope_v.data(),
	          m_edge.data());
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

}  // namespace explore::simulation
