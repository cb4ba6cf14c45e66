#include <explore/core/vector_code.h>
#include <explore/memory/ray_ends.h>

#include <array>
#include <utility>
#include <vector>

namespace explore
{
namespace
{
constexpr int kNoEnd = -1;

/** Rounds down; what truncation gets wrong below zero is mended, which vectorises, unlike std::floor. */
int roundedDown(float value)
{
	const int truncated = static_cast<int>(value);
	return truncated - static_cast<int>(value < static_cast<float>(truncated));
}

/** A row of rays in voxels from the window's corner: from + depth · (start + left · slope). */
struct Row
{
	std::array<float, 3> start, slope, origin;
	std::array<int, 3> from;  ///< added after rounding, to keep the digits
	const float *left, *reach_m, *depth_m;
	int width;
};

/** For each pixel of a row: the voxel of its end, as the place of the block in the window and that in the block in one
 *  number; kNoEnd without return or beyond the range. */
[[gnu::always_inline]] inline void findEnds(const Row& by_reference, int edge, int* __restrict ends)
{
	const Row row = by_reference;  // a copy: what it holds cannot change while `ends` is written
	for (int u = 0; u < row.width; ++u)
	{
		const float depth_m = row.reach_m[u], left = row.left[u];
		const int x = row.from[0] + roundedDown(row.origin[0] + depth_m * (row.start[0] + left * row.slope[0]));
		const int y = row.from[1] + roundedDown(row.origin[1] + depth_m * (row.start[1] + left * row.slope[1]));
		const int z = row.from[2] + roundedDown(row.origin[2] + depth_m * (row.start[2] + left * row.slope[2]));
		const int block = ((x >> kBlockBits) * edge + (y >> kBlockBits)) * edge + (z >> kBlockBits);
		const int ends_here = static_cast<int>(row.depth_m[u] > 0.0F) & static_cast<int>(row.depth_m[u] <= depth_m);
		ends[u] = (block * kBlockVoxels + placeInBlock(x, y, z)) | (ends_here - 1);  // kNoEnd has all bits set
	}
}
EXPLORE_VECTOR_CODE(findEndsOnThisProcessor, findEnds, (const Row& row, int edge, int* ends), (row, edge, ends))

Row rowOf(const FrameRays& rays, const DepthImage& image, int v, const BlockStore& store)
{
	Row row{};
	row.left = rays.left.data();
	row.reach_m = rays.rowOfReach(v);
	row.depth_m = image.depth_m.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(rays.width_px);
	row.width = rays.width_px;
	for (std::size_t i = 0; i < 3; ++i)
	{
		const auto axis = static_cast<Eigen::Index>(i);
		row.start[i] =
		    rays.voxels_from_camera(axis, 0) + rays.voxels_from_camera(axis, 2) * rays.up[static_cast<std::size_t>(v)];
		row.slope[i] = rays.voxels_from_camera(axis, 1);
		row.origin[i] = rays.origin[axis];
		row.from[i] = rays.origin_key[axis] - store.first()[axis] * kBlockEdge;
	}
	return row;
}

GridKey keyOfPlace(const BlockStore& store, int place)
{
	const int edge = store.edge();
	return store.first() + GridKey(place / (edge * edge), place / edge % edge, place % edge);
}
/** The block at that place, as one that is in this frame. */
VoxelBlock& enterBlock(int place, BlockStore& store, std::vector<VoxelBlock*>& in_frame)
{
	VoxelBlock* block = store.at(place);
	if (block == nullptr) block = &store.fetch(keyOfPlace(store, place));
	if (!std::exchange(block->in_frame, true)) in_frame.push_back(block);
	return *block;
}
}  // namespace

void markRayEnds(const FrameRays& rays, const DepthImage& image, BlockStore& store, std::vector<VoxelBlock*>& in_frame)
{
	std::vector<int> ends(static_cast<std::size_t>(rays.width_px));
	for (int v = 0; v < rays.height_px; ++v)
	{
		findEndsOnThisProcessor(rowOf(rays, image, v, store), store.edge(), ends.data());
		// Neighbours often end in one voxel, but noise makes it too hard to guess when to be worth a test.
		for (const int end : ends)
		{
			if (end == kNoEnd) continue;
			const int place = end >> (3 * kBlockBits);
			VoxelBlock* block = store.at(place);
			if (block == nullptr || !block->in_frame) block = &enterBlock(place, store, in_frame);
			block->hits.set(end & (kBlockVoxels - 1));
		}
	}
}
}  // namespace explore
