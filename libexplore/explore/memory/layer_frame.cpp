#include <explore/memory/layer_frame.h>

#include <algorithm>
#include <cmath>

namespace explore
{
int LayerFrame::nearestLayer(double z_m) const
{
	const auto nearer = [&](double a, double b) { return std::abs(a - z_m) < std::abs(b - z_m); };
	return static_cast<int>(std::min_element(altitudes_m.begin(), altitudes_m.end(), nearer) - altitudes_m.begin());
}

LayerCell LayerFrame::cellOf(std::size_t index) const
{
	const std::size_t row = index / static_cast<std::size_t>(columns);
	return {static_cast<int>(index % static_cast<std::size_t>(columns)),
	        static_cast<int>(row % static_cast<std::size_t>(rows)),
	        static_cast<int>(row / static_cast<std::size_t>(rows))};
}

LayerCell LayerFrame::cellAt(const Eigen::Vector2d& point_in_map, int layer) const
{
	const Eigen::Array2d number = (point_in_map.array() / resolution_m).floor();
	return {static_cast<int>(number.x()) - first.x(), static_cast<int>(number.y()) - first.y(), layer};
}

std::optional<std::size_t> LayerFrame::indexAt(const Eigen::Vector2d& point_in_map, int layer) const
{
	const LayerCell cell = cellAt(point_in_map, layer);
	if (!holds(cell)) return std::nullopt;
	return indexOf(cell);
}

Eigen::Vector2d LayerFrame::centreOf(std::size_t index) const
{
	const LayerCell cell = cellOf(index);
	return resolution_m * (first + Eigen::Vector2i(cell.column, cell.row)).cast<double>() +
	       Eigen::Vector2d::Constant(0.5 * resolution_m);
}

std::size_t movedIndex(std::size_t index, const LayerFrame& old, const LayerFrame& now)
{
	const LayerCell cell = old.cellOf(index);
	const Eigen::Vector2i shift = old.first - now.first;
	return now.indexOf({cell.column + shift.x(), cell.row + shift.y(), cell.layer});
}
}  // namespace explore
