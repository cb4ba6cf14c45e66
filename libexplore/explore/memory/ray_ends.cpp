#include <explore/memory/ray_ends.h>

namespace explore
{
namespace
{
/** For each pixel of a row: the place of its end's block in the window, and the voxel's in the block. */
struct RowEnds
{
	std::vector<int> block, voxel;

	explicit RowEnds(std::size_t width) : block(width), voxel(width) {}
};

/** Rounds down; what truncation gets wrong below zero is mended, which vectorises, unlike std::floor. */
int floorOf(float value)
{
	const int truncated = static_cast<int>(value);
	return truncated - static_cast<int>(value < static_cast<float>(truncated));
}

void findRowEnds(const FrameRays& rays, std::size_t v, const BlockStore& store, RowEnds& ends)
{
	const Eigen::Vector3f along = rays.voxels_from_camera * Eigen::Vector3f(1.0F, 0.0F, rays.up[v]);
	const Eigen::Vector3f across = rays.voxels_from_camera.col(1);
	const GridKey from = rays.origin_key - store.first() * kBlockEdge;  // so that all numbers are small and positive
	const int edge = store.edge();
	const float* reach_m = rays.reach_m.data() + v * rays.left.size();
	for (std::size_t u = 0; u < rays.left.size(); ++u)
	{
		const float depth_m = reach_m[u], left = rays.left[u];
		const int x = from.x() + floorOf(rays.origin.x() + depth_m * (along.x() + left * across.x()));
		const int y = from.y() + floorOf(rays.origin.y() + depth_m * (along.y() + left * across.y()));
		const int z = from.z() + floorOf(rays.origin.z() + depth_m * (along.z() + left * across.z()));
		ends.block[u] = ((x >> kBlockBits) * edge + (y >> kBlockBits)) * edge + (z >> kBlockBits);
		ends.voxel[u] = placeInBlock(x, y, z);
	}
}

GridKey keyOfPlace(const BlockStore& store, int place)
{
	const int edge = store.edge();
	return store.first() + GridKey(place / (edge * edge), place / edge % edge, place % edge);
}
}  // namespace

void markRayEnds(const FrameRays& rays, const DepthImage& image, BlockStore& store, std::vector<VoxelBlock*>& in_frame)
{
	const std::size_t width = rays.left.size();
	RowEnds ends(width);
	VoxelBlock* block = nullptr;
	int place = -1;
	for (std::size_t v = 0; v < rays.up.size(); ++v)
	{
		findRowEnds(rays, v, store, ends);
		const float* depth_m = image.depth_m.data() + v * width;
		const float* reach_m = rays.reach_m.data() + v * width;
		for (std::size_t u = 0; u < width; ++u)
		{
			if (depth_m[u] <= 0.0F || reach_m[u] < depth_m[u]) continue;  // no return, or beyond the range
			if (ends.block[u] != place)
			{
				place = ends.block[u];
				block = store.at(place);
				if (block == nullptr) block = &store.fetch(keyOfPlace(store, place));
				if (!std::exchange(block->in_frame, true)) in_frame.push_back(block);
			}
			block->hits.set(ends.voxel[u]);
		}
	}
}
}  // namespace explore
