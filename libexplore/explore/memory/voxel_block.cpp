#include <explore/memory/voxel_block.h>

namespace explore
{
GridKey VoxelBlock::voxelAt(int place) const
{
	const auto [x, y, z] = coordinatesOfPlace(place);
	return key * kBlockEdge + GridKey(x, y, z);
}
}  // namespace explore
