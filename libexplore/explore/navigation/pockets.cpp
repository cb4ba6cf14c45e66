#include <explore/navigation/pockets.h>

#include <algorithm>
#include <limits>

namespace explore
{
namespace
{
/** Whether the map ends beside it. */
bool isAtEdge(const PlanMap& map, CellIndex cell)
{
	const Eigen::Array3i place = map.placeOf(cell);
	return place.x() == 0 || place.y() == 0 || place.x() + 1 == map.frame.columns || place.y() + 1 == map.frame.rows;
}

/** Numbers what is joined to `first`, and tells its area. */
double fill(const PlanMap& map, CellIndex first, std::uint32_t number, Pockets& pockets)
{
	const double cell_m2 = map.frame.resolution_m * map.frame.resolution_m;
	double area_m2 = 0.0;
	std::vector<CellIndex> open{first};
	pockets.number[first] = number;
	while (!open.empty())
	{
		const CellIndex cell = open.back();
		open.pop_back();
		area_m2 += isAtEdge(map, cell) ? std::numeric_limits<double>::infinity() : cell_m2;
		forEachNext(map, cell,
		            [&](CellIndex next)
		            {
			            if (map.wanted[next] == 0 || pockets.number[next] != 0) return;
			            pockets.number[next] = number;
			            open.push_back(next);
		            });
	}
	return area_m2 / static_cast<double>(map.frame.altitudes_m.size());
}
}  // namespace

double Pockets::besideThose(const PlanMap& map, const std::vector<CellIndex>& cells) const
{
	std::vector<std::uint32_t> numbers;
	for (const CellIndex cell : cells) forEachNext(map, cell, [&](CellIndex next) { numbers.push_back(number[next]); });
	std::sort(numbers.begin(), numbers.end());
	numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
	double sum_m2 = 0.0;
	for (const std::uint32_t one : numbers) sum_m2 += area_m2[one];
	return sum_m2;
}

Pockets pocketsOf(const PlanMap& map)
{
	Pockets pockets{std::vector<std::uint32_t>(map.cells.size(), 0), {0.0}};
	for (std::size_t i = 0; i < map.cells.size(); ++i)
	{
		if (map.wanted[i] == 0 || pockets.number[i] != 0) continue;
		const auto number = static_cast<std::uint32_t>(pockets.area_m2.size());
		pockets.area_m2.push_back(fill(map, static_cast<CellIndex>(i), number, pockets));
	}
	return pockets;
}
}  // namespace explore
