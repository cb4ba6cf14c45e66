// Marks the voxels through which rays of a frame pass before they end: the space that is seen to be free.
#pragma once

#include <explore/memory/block_store.h>
#include <explore/memory/frame_rays.h>
#include <explore/memory/reach_pyramid.h>

namespace explore
{
/** Sets VoxelBlock::passes of just those voxels that the rays of the pixels, as lines without width, cross and leave
 *  again before they end; VoxelBlock::hits must be set and win. The voxels are looked up in the image rather than walked
 *  to (as wavemap does, Reijgwart et al. 2023): most of them are decided by the pixel that sees their centre or by the
 *  farthest reach around it; for those that neither decides, each ray that may cross is intersected with the voxel.
 *  Blocks that get a first bit are appended to `in_frame`. */
void markRayPasses(const FrameRays& rays, const ReachPyramid& pyramid, float range_m, BlockStore& store,
                   std::vector<VoxelBlock*>& in_frame);
}  // namespace explore
