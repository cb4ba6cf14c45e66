#include <explore/simulation/cell_spread.h>

#include <cmath>
#include <optional>

namespace explore::simulation
{
namespace
{
constexpr double kStartSearch_m = 0.3;

bool isFree(const TruthReach& reach, const std::vector<CellBytes>& blocked, const ReachCell& cell)
{
	return isInside(reach, cell) &&
	       blocked[static_cast<std::size_t>(cell.level)][planIndex(reach, cell.column, cell.row)] == 0;
}

std::optional<ReachCell> freeCellNear(const TruthReach& reach, const std::vector<CellBytes>& blocked,
                                      const Eigen::Vector3d& place)
{
	const ReachCell middle = cellAt(reach, place);
	if (isFree(reach, blocked, middle)) return middle;
	const int far = static_cast<int>(std::ceil(kStartSearch_m / reach.cell_m));
	std::optional<ReachCell> best;
	double best_m = kStartSearch_m;
	for (int row = middle.row - far; row <= middle.row + far; ++row)
		for (int column = middle.column - far; column <= middle.column + far; ++column)
		{
			const ReachCell cell{column, row, middle.level};
			const double away_m = (reach.centerOf(column, row) - place.head<2>()).norm();
			if (away_m >= best_m || !isFree(reach, blocked, cell)) continue;
			best = cell;
			best_m = away_m;
		}
	return best;
}
}  // namespace

std::size_t planIndex(const TruthReach& reach, int column, int row)
{
	return static_cast<std::size_t>(row) * static_cast<std::size_t>(reach.columns) + static_cast<std::size_t>(column);
}

ReachCell cellAt(const TruthReach& reach, const Eigen::Vector3d& point_in_map)
{
	const auto number = [&reach](double at_m) { return static_cast<int>(std::floor(at_m / reach.cell_m)); };
	ReachCell cell{number(point_in_map.x()) - reach.first_column, number(point_in_map.y()) - reach.first_row, 0};
	if (reach.levels.size() > 1)
		cell.level =
		    number(point_in_map.z()) - static_cast<int>(std::lround(reach.levels.front().low_m / reach.cell_m));
	return cell;
}

bool isInside(const TruthReach& reach, const ReachCell& cell)
{
	return cell.column >= 0 && cell.column < reach.columns && cell.row >= 0 && cell.row < reach.rows &&
	       cell.level >= 0 && cell.level < static_cast<int>(reach.levels.size());
}

void spread(TruthReach& reach, std::vector<CellBytes> blocked, const Eigen::Vector3d& start_in_map)
{
	std::vector<ReachCell> open;
	const auto visit = [&](const ReachCell& cell)
	{
		if (!isFree(reach, blocked, cell)) return;
		const auto level = static_cast<std::size_t>(cell.level);
		const std::size_t at = planIndex(reach, cell.column, cell.row);
		blocked[level][at] = 1;  // once is enough
		reach.levels[level].reachable[at] = 1;
		open.push_back(cell);
	};
	if (const auto start = freeCellNear(reach, blocked, start_in_map)) visit(*start);
	while (!open.empty())
	{
		const ReachCell at = open.back();
		open.pop_back();
		for (const int step : {-1, 1})
		{
			visit({at.column + step, at.row, at.level});
			visit({at.column, at.row + step, at.level});
			visit({at.column, at.row, at.level + step});
		}
	}
}
}  // namespace explore::simulation
