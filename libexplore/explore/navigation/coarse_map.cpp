#include <explore/navigation/coarse_map.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore
{
int coarseness(const PlanMap& map, const RobotConfig& robot, const PlanConfig& config)
{
	// Middles of passable cells on both sides of a thing are farther apart than this, those of two squares that touch
	// at a corner at most (2 factor - 1) diagonals of a cell.
	const double apart_m = 2.0 * (robot.radius_m + config.squeeze_m);
	const double diagonals = apart_m / (std::numbers::sqrt2 * map.frame.resolution_m);
	return std::max(1, static_cast<int>(std::floor(0.5 * (diagonals + 1.0))));
}

PlanMap coarsened(const PlanMap& map, int factor)
{
	PlanMap coarse;
	coarse.frame = map.frame;
	coarse.frame.resolution_m = map.frame.resolution_m * factor;
	coarse.frame.columns = (map.frame.columns + factor - 1) / factor;
	coarse.frame.rows = (map.frame.rows + factor - 1) / factor;
	coarse.fit_m = map.fit_m;
	const std::size_t count = coarse.frame.size();
	coarse.cells.assign(count, CellState::unknown);
	coarse.obstacle_m.assign(count, 0.0F);
	coarse.allowed.assign(count, 0);
	coarse.passable.assign(count, 0);
	coarse.blocked.assign(count, 1);
	for (CellIndex cell = 0; cell < map.cells.size(); ++cell)
	{
		if (map.cells[cell] != CellState::free) continue;
		const CellIndex square = squareOf(map, coarse, cell, factor);
		coarse.cells[square] = CellState::free;
		coarse.allowed[square] |= map.allowed[cell];
		if (map.passable[cell] == 0) continue;
		coarse.passable[square] = 1;
		coarse.blocked[square] &= map.blocked[cell];
		coarse.obstacle_m[square] = std::max(coarse.obstacle_m[square], map.obstacle_m[cell]);
	}
	return coarse;
}

CellIndex squareOf(const PlanMap& map, const PlanMap& coarse, CellIndex cell, int factor)
{
	if (cell == kNoCell) return kNoCell;
	const Eigen::Array3i place = map.placeOf(cell);
	return coarse.cellAt({place.x() / factor, place.y() / factor, place.z()});
}
}  // namespace explore
