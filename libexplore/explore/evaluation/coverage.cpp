#include <explore/evaluation/coverage.h>

#include <cmath>

namespace explore::evaluation
{
namespace
{
VoxelState stateAt(const FloorMap& floor, const Eigen::Vector2d& point_in_map)
{
	const Eigen::Array2d cell = ((point_in_map - floor.corner_in_map) / floor.resolution_m).array().floor();
	const bool inside = (cell >= 0.0).all() && cell.x() < static_cast<double>(floor.columns) &&
	                    cell.y() < static_cast<double>(floor.rows);
	if (!inside) return VoxelState::unknown;
	return floor.cells[static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(floor.columns) +
	                   static_cast<std::size_t>(cell.x())];
}
}  // namespace

double Coverage::share() const
{
	return reachable > 0 ? static_cast<double>(covered) / static_cast<double>(reachable) : 1.0;
}

Coverage coverageOf(const TruthReach& reach, const octomap::OcTree& map)
{
	Coverage coverage;
	for (const TruthReach::Level& level : reach.levels)
	{
		const FloorMap floor = floorMap(map, {0.0, level.low_m, level.high_m});
		std::size_t cell = 0;
		for (int row = 0; row < reach.rows; ++row)
			for (int column = 0; column < reach.columns; ++column)
			{
				if (level.reachable[cell++] == 0) continue;
				++coverage.reachable;
				if (stateAt(floor, reach.centerOf(column, row)) == VoxelState::free) ++coverage.covered;
			}
	}
	return coverage;
}
}  // namespace explore::evaluation
