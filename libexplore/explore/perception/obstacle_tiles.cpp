#include <explore/perception/obstacle_tiles.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace explore
{
namespace
{
/** However near a thing is, it need not fill more of a tile and those beside it. */
constexpr double kFilledShare = 0.25;
}  // namespace

TileSize tileSize(const RobotConfig& robot, const CameraIntrinsics& camera)
{
	constexpr double kVgaWidth = 640.0;
	const double scale = camera.width_px / kVgaWidth;
	const auto scaled = [&](double pixels)
	{ return static_cast<std::size_t>(std::max(1.0, std::round(pixels * scale))); };
	return robot.kind == RobotKind::mav ? TileSize{scaled(4), scaled(16)} : TileSize{scaled(2), scaled(32)};
}

ObstacleTiles::ObstacleTiles(const CameraIntrinsics& camera, const TileSize& size, double min_area_m2)
    : m_size(size),
      m_area_px2(min_area_m2 * camera.fx_px * camera.fy_px),
      m_most_px(kFilledShare * static_cast<double>(3 * size.width * size.height)),
      m_spans((static_cast<std::size_t>(camera.width_px) + size.width - 1) / size.width + 2),
      m_layers(m_spans.size() * kLayers)
{
}

std::size_t ObstacleTiles::layerOf(float depth_m)
{
	// The leading bits of a float are its logarithm, near enough: layers are 6 % deep, from 0.125 m on.
	constexpr int kBits = 19;
	constexpr std::int32_t kFirst = std::bit_cast<std::int32_t>(0.125F) >> kBits;
	const std::int32_t layer = (std::bit_cast<std::int32_t>(depth_m) >> kBits) - kFirst;
	return static_cast<std::size_t>(std::clamp(layer, 0, static_cast<std::int32_t>(kLayers) - 1));
}

void ObstacleTiles::add(const std::vector<float>& depth_m, std::size_t v)
{
	for (std::size_t u = 0; u < depth_m.size(); ++u)
	{
		if (!(depth_m[u] < kNothing)) continue;
		const std::size_t tile = u / m_size.width + 1, place = layerOf(depth_m[u]);
		Span& span = m_spans[tile];
		span = {std::min(span.first, place), std::max(span.end, place + 1)};
		Layer& layer = m_layers[tile * kLayers + place];
		++layer.count;
		if (depth_m[u] >= layer.depth_m) continue;
		layer.depth_m = depth_m[u];
		layer.u = static_cast<std::uint16_t>(u);
		layer.v = static_cast<std::uint16_t>(v);
	}
}

const ObstacleTiles::Layer* ObstacleTiles::nearestThing(std::size_t tile) const
{
	for (std::size_t i = m_spans[tile].first; i < m_spans[tile].end; ++i)
	{
		const Layer& layer = m_layers[tile * kLayers + i];
		if (layer.count == 0) continue;
		std::uint32_t around = 0;
		for (std::size_t beside = tile - 1; beside <= tile + 1; ++beside)
			for (std::size_t k = i > 0 ? i - 1 : i; k <= std::min(i + 1, kLayers - 1); ++k)
				around += m_layers[beside * kLayers + k].count;
		const double enough_px = m_area_px2 / (static_cast<double>(layer.depth_m) * layer.depth_m);
		if (around >= std::min(enough_px, m_most_px)) return &layer;
	}
	return nullptr;
}

std::vector<ObstacleTiles::Pixel> ObstacleTiles::take()
{
	std::vector<Pixel> pixels;
	for (std::size_t tile = 1; tile + 1 < m_spans.size(); ++tile)
		if (const Layer* nearest = nearestThing(tile)) pixels.push_back({nearest->u, nearest->v});
	for (std::size_t tile = 0; tile < m_spans.size(); ++tile)
	{
		for (std::size_t i = m_spans[tile].first; i < m_spans[tile].end; ++i) m_layers[tile * kLayers + i] = Layer();
		m_spans[tile] = Span();
	}
	return pixels;
}
}  // namespace explore
