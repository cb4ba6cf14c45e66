// Carries blocks of voxels into an octomap::OcTree and back, a subtree at a time.
#pragma once

#include <explore/memory/voxel_block.h>
#include <octomap/OcTree.h>

namespace explore
{
/** The log-odds of the block's voxels as the tree's leaves have them. */
BlockValues readBlock(const octomap::OcTree& tree, const GridKey& block);

/** Makes the tree's leaves in that block those of `values`, the pruned form of them. Inner nodes below the block's are
 *  right afterwards, those above it only after updateInnerNodes(). */
void writeBlock(octomap::OcTree& tree, const GridKey& block, const BlockValues& values);

/** Sets the nodes above the blocks to the largest of their children, as OctoMap has them, and joins equal ones. */
void updateInnerNodes(octomap::OcTree& tree);
}  // namespace explore
