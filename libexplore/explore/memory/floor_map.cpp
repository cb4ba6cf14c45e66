#include <explore/memory/floor_map.h>
#include <explore/memory/key_range.h>

namespace explore
{
namespace
{
/** Calls visit(KeyBox, bool occupied) for the leaves that reach into the band. */
template <class Visit>
void forEachInBand(const octomap::OcTree& map, const FloorBand& band, const Visit& visit)
{
	const KeyRange layers =
	    keysBetween(band.floor_z_m + band.lowest_m, band.floor_z_m + band.highest_m, map.getResolution());
	forEachLeaf(map,
	            [&](const KeyBox& leaf, bool occupied)
	            {
		            if (leaf.z.common(layers).size() > 0) visit(leaf, occupied);
	            });
}
}  // namespace

FloorMap floorMap(const octomap::OcTree& map, const FloorBand& band)
{
	KeyRange x, y;
	forEachInBand(map, band, [&](const KeyBox& leaf, bool) { x = x.with(leaf.x), y = y.with(leaf.y); });
	FloorMap floor;
	floor.resolution_m = map.getResolution();
	if (x.size() == 0) return floor;
	floor.corner_in_map = floor.resolution_m * Eigen::Vector2d(x.first - kOriginKey, y.first - kOriginKey);
	floor.columns = x.size();
	floor.rows = y.size();
	floor.cells.assign(static_cast<std::size_t>(floor.columns) * static_cast<std::size_t>(floor.rows),
	                   VoxelState::unknown);
	forEachInBand(map, band,
	              [&](const KeyBox& leaf, bool occupied)
	              {
		              const VoxelState state = occupied ? VoxelState::occupied : VoxelState::free;
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
