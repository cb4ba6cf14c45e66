#include <explore/simulation/projector_shadow.h>

#include <algorithm>
#include <cstddef>

namespace explore::simulation
{
std::vector<std::uint8_t> tilesInDoubt(const TileStrip& strip, int width_px, float unseen_px)
{
	// A point lies in the shadow of what has a greater disparity d, stands to its right and on the same line of the
	// projector: whose d − u is as great at least. What shows at a pixel may begin almost a pixel to the left of it; a
	// little less of slack spares the rays to gently slanted walls.
	constexpr float kSlack_px = 0.95F;
	std::vector<std::uint8_t> in_doubt(static_cast<std::size_t>(strip.tiles));
	for (int row = 0; row < kTileSide; ++row)
	{
		float greatest = unseen_px - static_cast<float>(width_px);  // d − u of all that is to the right
		for (int u = strip.tiles * kTileSide - 1; u >= 0; --u)
		{
			const auto tile = static_cast<std::size_t>(u / kTileSide);
			const auto lane = static_cast<std::size_t>(row) * kTileSide + static_cast<std::size_t>(u % kTileSide);
			const float line = strip.disparity[tile * kLanes + lane] - static_cast<float>(u);
			if (greatest > line - kSlack_px)
			{
				in_doubt[tile] = 1;
				if (u % kTileSide == 0 && tile > 0) in_doubt[tile - 1] = 1;
			}
			greatest = std::max(greatest, line);
		}
	}
	return in_doubt;
}
}  // namespace explore::simulation
