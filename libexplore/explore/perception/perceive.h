// Perception of one frame: paper §3.1, the first 25 lines of Algorithm 1, and what method = full makes of them.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/results.h>
#include <explore/perception/perception_config.h>

namespace explore
{
/** What perception carries from frame to frame. */
struct PerceptionMemory
{
	GroundMemory ground;
};

/** P_f of Algorithm 1, lines 2–3: what rangeFilter() and voxelGrid() give one after the other, without the full cloud
 * in between, which costs more memory traffic than all the rest. */
PointCloud filteredVoxels(const DepthFrame& frame, const RangeFilterConfig& range_filter,
                          const VoxelGridConfig& voxel_grid);

/** Same frame, config, robot and memory: same result. Unorganised clouds have no rays to ask: their walls and doors are
 *  found by the paper's method, whatever the config says. */
Percepts perceive(const DepthFrame& frame, const PerceptionConfig& config, const RobotConfig& robot,
                  PerceptionMemory& memory);
/** The same for a frame by itself. */
Percepts perceive(const DepthFrame& frame, const PerceptionConfig& config, const RobotConfig& robot = {});
}  // namespace explore
