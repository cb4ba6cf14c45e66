#include <explore/memory/floor_map.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace explore
{
namespace
{
constexpr double kFace = 1e-9;  // of a voxel: heights that near to a face are on it

/** Keys from first to last, ends included. */
struct KeyRange
{
	int first, last;
};

/** Layers of voxels in the band. */
KeyRange layersOf(const octomap::OcTree& map, const FloorBand& band)
{
	const double low = (band.floor_z_m + band.lowest_m) / map.getResolution();
	const double high = (band.floor_z_m + band.highest_m) / map.getResolution();
	return {kOriginKey + static_cast<int>(std::floor(low + kFace)),
	        kOriginKey + static_cast<int>(std::ceil(high - kFace)) - 1};
}

/** The cells that a leaf stands for, which reaches into the band. */
struct Footprint
{
	KeyRange x, y;
	bool occupied;
};

template <class Visit>
void forEachInBand(const octomap::OcTree& map, const FloorBand& band, const Visit& visit)
{
	const KeyRange layers = layersOf(map, band);
	for (auto leaf = map.begin_leafs(), end = map.end_leafs(); leaf != end; ++leaf)
	{
		const octomap::OcTreeKey first = leaf.getIndexKey();
		const int last = (1 << (map.getTreeDepth() - leaf.getDepth())) - 1;
		if (first[2] > layers.last || first[2] + last < layers.first) continue;
		visit(Footprint{{first[0], first[0] + last}, {first[1], first[1] + last}, map.isNodeOccupied(*leaf)});
	}
}
}  // namespace

FloorMap floorMap(const octomap::OcTree& map, const FloorBand& band)
{
	KeyRange x{INT32_MAX, INT32_MIN}, y = x;
	const auto extend = [](KeyRange& range, const KeyRange& by) {
		range = {std::min(range.first, by.first), std::max(range.last, by.last)};
	};
	forEachInBand(map, band, [&](const Footprint& leaf) { extend(x, leaf.x), extend(y, leaf.y); });
	FloorMap floor;
	floor.resolution_m = map.getResolution();
	if (x.first > x.last) return floor;
	floor.corner_in_map = floor.resolution_m * Eigen::Vector2d(x.first - kOriginKey, y.first - kOriginKey);
	floor.columns = x.last - x.first + 1;
	floor.rows = y.last - y.first + 1;
	floor.cells.assign(static_cast<std::size_t>(floor.columns) * static_cast<std::size_t>(floor.rows),
	                   VoxelState::unknown);
	forEachInBand(map, band,
	              [&](const Footprint& leaf)
	              {
		              const VoxelState state = leaf.occupied ? VoxelState::occupied : VoxelState::free;
		              for (int row = leaf.y.first - y.first; row <= leaf.y.last - y.first; ++row)
			              for (int column = leaf.x.first - x.first; column <= leaf.x.last - x.first; ++column)
			              {
				              VoxelState& cell =
				                  floor.cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(floor.columns) +
				                              static_cast<std::size_t>(column)];
				              cell = std::max(cell, state);
			              }
	              });
	return floor;
}
}  // namespace explore
