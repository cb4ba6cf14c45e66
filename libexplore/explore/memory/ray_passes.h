// Marks the voxels through which rays of a frame pass before they end: the space that is seen to be free.
#pragma once

#include <explore/memory/block_store.h>
#include <explore/memory/frame_rays.h>
#include <explore/memory/reach_pyramid.h>

namespace explore
{
/** Sets VoxelBlock::passes of just those voxels that the rays of the pixels, as lines without width, cross and leave
 *  again before they end; but for VoxelBlock::hits, which must be set and win, and VoxelBlock::settled, which a pass
 * does not change. Blocks that get a first bit are appended to `in_frame`.
 *
 *  The voxels are looked up in the image rather than walked to, from large cubes to small ones (as wavemap does,
 *  Reijgwart et al. 2023): the farthest reach in a part of the image says that nothing passes there, the pixel that
 * sees a voxel's centre that something does; where neither decides, the rays are intersected with the voxel. */
void markRayPasses(const FrameRays& rays, const ReachPyramid& pyramid, float range_m, BlockStore& store,
                   std::vector<VoxelBlock*>& in_frame);
}  // namespace explore
