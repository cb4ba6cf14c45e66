// Thins the obstacle pixels of an image: of each tile the nearest thing, specks of noise left out.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/robot.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace explore
{
/** Side lengths in pixels, at the same angle for any resolution. */
struct TileSize
{
	std::size_t width, height;
};
/** Narrow and high for a ground robot, which needs to know how far aside things are; lower for a MAV. */
TileSize tileSize(const RobotConfig& robot, const CameraIntrinsics& camera);

/** Collects a band of image rows, a tile high. The pixels of a tile are sorted into layers of depth; the nearest layer
 *  that is no speck gives the tile's pixel. */
class ObstacleTiles
{
public:
	/** Means "no obstacle" as a depth. */
	static constexpr float kNothing = std::numeric_limits<float>::infinity();
	struct Pixel
	{
		std::size_t u, v;
	};

	/** Less than `min_area_m2` of a thing, facing the camera, is a speck. */
	ObstacleTiles(const CameraIntrinsics& camera, const TileSize& size, double min_area_m2);

	/** Row v: the depth of each pixel's obstacle, or kNothing. */
	void add(const std::vector<float>& depth_m, std::size_t v);
	/** The nearest pixel of each tile that shows a thing, from left to right; the tiles are empty afterwards. */
	[[nodiscard]] std::vector<Pixel> take();

private:
	static constexpr std::size_t kLayers = 96;
	struct Layer
	{
		float depth_m = kNothing;
		std::uint16_t u = 0, v = 0;
		std::uint32_t count = 0;
	};
	/** The layers of a tile that hold anything lie between these. */
	struct Span
	{
		std::size_t first = kLayers, end = 0;
	};

	static std::size_t layerOf(float depth_m);
	/** The nearest layer of a tile that, with the tiles beside it and the layers before and behind, shows enough of a
	 *  thing; null without one. */
	[[nodiscard]] const Layer* nearestThing(std::size_t tile) const;

	TileSize m_size;
	double m_area_px2;            ///< of the least thing at a depth of 1 m
	double m_most_px;             ///< of a tile and those beside it, that a thing need not exceed however near it is
	std::vector<Span> m_spans;    ///< of each tile; there is an empty one before the first and behind the last
	std::vector<Layer> m_layers;  ///< tile by tile
};
}  // namespace explore
