// How far each cell of a grid is from the nearest marked one, up to a limit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace explore
{
struct GridSize
{
	int columns = 0, rows = 0;
};

/** Euclidean distance between the cells' middles, in cells, at most `limit` (1 to 127); `marked` is row-major. Two
 *  passes over rows and columns (Saito & Toriwaki 1994). */
std::vector<float> cappedDistance(std::span<const std::uint8_t> marked, GridSize size, int limit);
}  // namespace explore
