// Marks the voxels in which the rays of a frame end.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/memory/block_store.h>
#include <explore/memory/frame_rays.h>

namespace explore
{
/** Sets VoxelBlock::hits where a ray ends within its range, every one of them, so that nothing thin is lost. Blocks
 * that get a first bit are appended to `in_frame`. The window must hold everything within the range. */
void markRayEnds(const FrameRays& rays, const DepthImage& image, BlockStore& store, std::vector<VoxelBlock*>& in_frame);
}  // namespace explore
