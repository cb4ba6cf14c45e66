#include <explore/perception/doorway_plan.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kLowest_m = 0.08;  // the lowest thing that must be noticed reaches this far over the band's bottom
constexpr double kFound = 0.15;     // of its rays return from where it is
constexpr int kFewest = 4;
constexpr float kLane_m = 0.45F;                                                                 // behind the wall
constexpr std::array kLaneSlopes{-1.7F, -1.0F, -0.58F, -0.27F, 0.0F, 0.27F, 0.58F, 1.0F, 1.7F};  // 60° to both sides
constexpr int kMostSteps = 40;  // of a ray through the doorway
}  // namespace

DoorwayPlan::DoorwayPlan(double width_m, double front_m, double behind_m, double rays_per_m2)
    : m_front_m(static_cast<float>(front_m)),
      m_columns(std::max(1, static_cast<int>(std::ceil(width_m / kCell_m)))),
      m_rows(std::max(1, static_cast<int>(std::ceil((front_m + behind_m) / kCell_m)))),
      m_enough(std::max(kFewest, static_cast<int>(kFound * rays_per_m2 * kCell_m * kLowest_m))),
      m_cells(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows))
{
}

DoorwayPlan::Cell* DoorwayPlan::cellAt(float along_m, float behind_m)
{
	const int column = static_cast<int>(std::floor(along_m / kCell_m));
	const int row = static_cast<int>(std::floor((behind_m + m_front_m) / kCell_m));
	if (column < 0 || column >= m_columns || row < 0 || row >= m_rows) return nullptr;
	return &m_cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) +
	                static_cast<std::size_t>(column)];
}

void DoorwayPlan::add(float along_m, float behind_m, float height_m)
{
	Cell* cell = cellAt(along_m, behind_m);
	if (cell == nullptr) return;
	++cell->count;
	cell->along_sum_m += along_m;
	cell->behind_sum_m += behind_m;
	cell->top_m = std::max(cell->top_m, height_m);
}

void DoorwayPlan::addSight(float along_m, float end_along_m, float end_behind_m)
{
	const float length_m = std::hypot(end_along_m - along_m, end_behind_m);
	const int steps = std::min(kMostSteps, static_cast<int>(length_m / kCell_m));
	const float step_along_m = (end_along_m - along_m) * kCell_m / std::max(length_m, kCell_m);
	const float step_behind_m = end_behind_m * kCell_m / std::max(length_m, kCell_m);
	for (int i = 0; i < steps; ++i)
	{
		const float at = static_cast<float>(i) + 0.5F;
		Cell* cell = cellAt(along_m + at * step_along_m, at * step_behind_m);
		if (cell == nullptr) return;
		++cell->sights;
	}
}

bool DoorwayPlan::stands(const Cell& cell) const
{
	return cell.count >= m_enough;
}

std::vector<Eigen::Vector2d> DoorwayPlan::obstacles() const
{
	std::vector<Eigen::Vector2d> centers;
	centers.reserve(m_cells.size() / 8);
	for (const Cell& cell : m_cells)
		if (stands(cell))
			centers.emplace_back(cell.along_sum_m / static_cast<float>(cell.count),
			                     cell.behind_sum_m / static_cast<float>(cell.count));
	return centers;
}

/** Whether the lane's cells that begin in `column` are all free; per_row: columns that it moves sideways per row. */
bool DoorwayPlan::isSeenFree(int column, float per_row) const
{
	const int first_row = static_cast<int>(m_front_m / kCell_m);
	const int rows = std::min(m_rows - first_row, static_cast<int>(kLane_m / kCell_m));
	bool looked = false;
	for (int row = 0; row < rows; ++row)
	{
		const int at = column + static_cast<int>(std::lround(per_row * (static_cast<float>(row) + 0.5F)));
		if (at < 0 || at >= m_columns) continue;  // beyond the jamb: not looked at here
		const Cell& cell = m_cells[static_cast<std::size_t>(first_row + row) * static_cast<std::size_t>(m_columns) +
		                           static_cast<std::size_t>(at)];
		if (cell.sights == 0 || stands(cell)) return false;
		looked = true;
	}
	return looked;
}

double DoorwayPlan::seenLane_m() const
{
	double widest_m = 0;
	for (const float per_row : kLaneSlopes)
	{
		int run = 0, longest = 0;
		for (int column = 0; column < m_columns; ++column)
		{
			run = isSeenFree(column, per_row) ? run + 1 : 0;
			longest = std::max(longest, run);
		}
		widest_m = std::max(widest_m, static_cast<double>(longest) * kCell_m / std::hypot(1.0, per_row));
	}
	return widest_m;
}

double DoorwayPlan::top_m() const
{
	float top_m = 0;
	for (const Cell& cell : m_cells)
		if (stands(cell)) top_m = std::max(top_m, cell.top_m);
	return top_m;
}
}  // namespace explore
