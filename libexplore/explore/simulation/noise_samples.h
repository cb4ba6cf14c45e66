// What the pixels of a depth image hand to those that look at them: disparity, its slope, and whether it returns.
#pragma once

#include <explore/simulation/noise_random.h>
#include <explore/simulation/sensor_view.h>

#include <cstddef>
#include <numbers>

namespace explore::simulation
{
constexpr float kHalfPi = std::numbers::pi_v<float> / 2;
constexpr float kSteepest_rad = 88.0F / 90.0F * kHalfPi;  ///< beyond it the pattern is too stretched for any return
constexpr double kEdgePerFocalLength = 0.5 / 585.0;       ///< a jump of half a pixel of a VGA picture is an edge

/** What a pixel hands to those that look at it. */
struct Sample
{
	float disparity_px = 0;          ///< 0 = nothing there
	float slope_u = 0, slope_v = 0;  ///< of the disparity [px/px]; 0 at an edge
	float cosine = -1;               ///< of the incidence; −1 = gives no return
};

/** Samples of the rows around the one that is measured: a ring, so that they stay in the cache. */
class SampleWindow
{
public:
	SampleWindow(const SensorView& view, const DepthCameraConfig& config, std::uint64_t seed)
	    : m_view(view),
	      m_focal_baseline(static_cast<float>(config.intrinsics.fx_px * config.baseline_m)),
	      m_edge_px(static_cast<float>(kEdgePerFocalLength * config.intrinsics.fx_px)),
	      m_edge_dropout(static_cast<float>(config.edge_dropout)),
	      m_edge_key(noiseKey(seed, 12)),
	      m_width(static_cast<std::size_t>(config.intrinsics.width_px)),
	      m_height(config.intrinsics.height_px),
	      m_reach(reachOf(config)),
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
	[[nodiscard]] static int reachOf(const DepthCameraConfig& config);
	[[nodiscard]] std::size_t ringRow(int v) const { return static_cast<std::size_t>(v % (2 * m_reach + 1)) * m_width; }
	/** The disparities of row `v`, which goes on straight for one pixel beyond both ends, as do the rows. */
	void disparities(int v, std::vector<float>& padded) const;
	void sampleOne(int v);

	const SensorView& m_view;
	float m_focal_baseline, m_edge_px, m_edge_dropout;
	NoiseKey m_edge_key;
	std::size_t m_width;
	int m_height, m_reach, m_next = -1;  ///< the next row to sample; −1 before the first
	std::vector<Sample> m_ring;
	std::vector<float> m_above, m_here, m_below, m_slope_u, m_slope_v, m_edge;
};
}  // namespace explore::simulation
