// The map seen from above, as a robot that stays on the floor needs it.
#pragma once

#include <explore/memory/voxel_block.h>
#include <octomap/OcTree.h>

#include <Eigen/Core>
#include <vector>

namespace explore
{
/** Heights above the floor, map frame: what is occupied between them is in the robot's way. */
struct FloorBand
{
	double floor_z_m = 0.0;
	double lowest_m = 0.10, highest_m = 0.60;
};

/** Square cells; (column, row) is at row · columns + column, row 0 at the smallest y. */
struct FloorMap
{
	double resolution_m = 0.0;
	Eigen::Vector2d corner_in_map = Eigen::Vector2d::Zero();  ///< of cell (0, 0), the one with the smallest x and y
	int columns = 0, rows = 0;
	std::vector<VoxelState> cells;
};

/** A cell is occupied where any voxel of its column in the band is, free where none is and one at least is free, and
 *  unknown otherwise. The voxels that the band touches count, those that it only touches at its upper end do not. The
 * map reaches as far as anything is known in the band; without that it has no cells. */
FloorMap floorMap(const octomap::OcTree& map, const FloorBand& band);
}  // namespace explore
