// Perception of one frame: paper §3.1, the first 25 lines of Algorithm 1. Pure: same frame, config and seed, same
// result.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/results.h>
#include <explore/perception/perception_config.h>

namespace explore
{
/** P_f of Algorithm 1, lines 2–3: what rangeFilter() and voxelGrid() give one after the other, without the full cloud
 * in between, which costs more memory traffic than all the rest. */
PointCloud filteredVoxels(const DepthFrame& frame, const RangeFilterConfig& range_filter,
                          const VoxelGridConfig& voxel_grid);

Percepts perceive(const DepthFrame& frame, const PerceptionConfig& config);
}  // namespace explore
