#include <explore/perception/doorway_plan.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kLowest_m = 0.08;  // the lowest thing that must be noticed reaches this far over the band's bottom
constexpr double kFound = 0.15;     // of its rays return from where it is
constexpr int kFewest = 4;
}  // namespace

DoorwayPlan::DoorwayPlan(double width_m, double front_m, double behind_m, double rays_per_m2)
    : m_front_m(static_cast<float>(front_m)),
      m_columns(std::max(1, static_cast<int>(std::ceil(width_m / kCell_m)))),
      m_rows(std::max(1, static_cast<int>(std::ceil((front_m + behind_m) / kCell_m)))),
      m_enough(std::max(kFewest, static_cast<int>(kFound * rays_per_m2 * kCell_m * kLowest_m))),
      m_cells(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows))
{
}

void DoorwayPlan::add(float along_m, float behind_m, float height_m)
{
	const int column = static_cast<int>(std::floor(along_m / kCell_m));
	const int row = static_cast<int>(std::floor((behind_m + m_front_m) / kCell_m));
	if (column < 0 || column >= m_columns || row < 0 || row >= m_rows) return;
	Cell& cell =
	    m_cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) + static_cast<std::size_t>(column)];
	++cell.count;
	cell.along_sum_m += along_m;
	cell.behind_sum_m += behind_m;
	cell.top_m = std::max(cell.top_m, height_m);
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

double DoorwayPlan::top_m() const
{
	float top_m = 0;
	for (const Cell& cell : m_cells)
		if (stands(cell)) top_m = std::max(top_m, cell.top_m);
	return top_m;
}
}  // namespace explore
