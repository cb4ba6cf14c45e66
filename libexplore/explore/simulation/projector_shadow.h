// Where the projector's light does not reach: which tiles of a picture need shadow rays at all.
#pragma once

#include <explore/simulation/ray_packets.h>

#include <vector>

namespace explore::simulation
{
/** What is seen by a row of tiles. */
struct TileStrip
{
	explicit TileStrip(int width_px)
	    : tiles((width_px + kTileSide - 1) / kTileSide),
	      points(static_cast<std::size_t>(tiles)),
	      can_be_dark(static_cast<std::size_t>(tiles)),
	      disparity(static_cast<std::size_t>(tiles) * kLanes)
	{
	}

	int tiles;
	std::vector<TileVectors> points;    ///< in the map
	std::vector<TileMask> can_be_dark;  ///< lanes that have a point and light to lose
	std::vector<float> disparity;       ///< between camera and projector of the first surface [px], by tile and lane
};

/** Tiles in which the projector's shadow may fall, 1 or 0 each. `unseen_px` is the greatest disparity of what may stand
 *  to the right of the picture, out of sight. */
std::vector<std::uint8_t> tilesInDoubt(const TileStrip& strip, int width_px, float unseen_px);
}  // namespace explore::simulation
