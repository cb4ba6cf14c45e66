// The layers of a body, worked out anew from the whole octree: slow and obvious.
#pragma once

#include <explore/memory/body_layers.h>
#include <explore/memory/floor_map.h>

#include <vector>

namespace explore::test
{
/** Heights over the floor, which is at z = 0. */
struct HeightSpan
{
	double low_m, high_m;
};

/** How many voxels of the column over the cell's centre are of that state, of those that the span cuts. */
inline int voxelsInColumn(const octomap::OcTree& map, const Eigen::Vector2d& at, const HeightSpan& span,
                          VoxelState state)
{
	const double edge_m = map.getResolution();
	int count = 0;
	for (int k = -100; k < 200; ++k)
	{
		if (k * edge_m > span.high_m - 1e-6 || (k + 1) * edge_m < span.low_m + 1e-6) continue;
		const octomap::OcTreeNode* voxel = map.search(at.x(), at.y(), (k + 0.5) * edge_m);
		if (voxel != nullptr && map.isNodeOccupied(voxel) == (state == VoxelState::occupied)) ++count;
	}
	return count;
}

/** What the body meets in that span, by floorMap(); drops too where a ground robot is asked about. */
inline std::vector<CellState> layerReference(const octomap::OcTree& map, const LayerFrame& frame,
                                             const HeightSpan& span, RobotKind kind)
{
	std::vector<CellState> cells(frame.cellsInLayer(), CellState::unknown);
	const FloorMap seen = floorMap(map, {.floor_z_m = 0, .lowest_m = span.low_m, .highest_m = span.high_m});
	for (std::size_t i = 0; i < cells.size(); ++i)
	{
		const Eigen::Vector2d centre = frame.centreOf(i);
		const Eigen::Array2d place = (centre - seen.corner_in_map).array() / frame.resolution_m;
		VoxelState state = VoxelState::unknown;
		if ((place >= 0).all() && place.x() < seen.columns && place.y() < seen.rows)
			state = seen.cells[static_cast<std::size_t>(place.y()) * static_cast<std::size_t>(seen.columns) +
			                   static_cast<std::size_t>(place.x())];
		if (state == VoxelState::free) cells[i] = CellState::free;
		if (state == VoxelState::occupied) cells[i] = CellState::occupied;
		if (kind == RobotKind::ground && state != VoxelState::occupied &&
		    voxelsInColumn(map, centre, {-0.5, -0.1}, VoxelState::free) > 0 &&
		    voxelsInColumn(map, centre, {-0.075, 0.075}, VoxelState::occupied) == 0)
			cells[i] = CellState::drop;
	}
	return cells;
}

/** All layers of a robot in doc/frames.md's sizes: ground 0.05–0.60 m, a MAV 0.35 m of height about each altitude. */
inline std::vector<CellState> layersReference(const octomap::OcTree& map, const LayerFrame& frame, RobotKind kind)
{
	std::vector<CellState> all;
	const auto add = [&](const HeightSpan& span)
	{
		const std::vector<CellState> layer = layerReference(map, frame, span, kind);
		all.insert(all.end(), layer.begin(), layer.end());
	};
	if (kind == RobotKind::ground)
		add({0.05, 0.60});
	else
		for (const double altitude_m : frame.altitudes_m) add({altitude_m - 0.175, altitude_m + 0.175});
	return all;
}

inline RobotConfig robotOf(RobotKind kind)
{
	RobotConfig robot;
	robot.kind = kind;
	if (kind == RobotKind::mav)
	{
		robot.radius_m = 0.30;
		robot.height_m = 0.25;
	}
	return robot;
}
}  // namespace explore::test
