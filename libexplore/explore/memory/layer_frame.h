// The rectangle of square cells in which layers over the map lie one on another, and what is where in it.
#pragma once

#include <explore/memory/key_range.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace explore
{
struct LayerCell
{
	int column = 0, row = 0, layer = 0;
};

/** Cell (column, row) of layer k is at (k · rows + row) · columns + column; row 0 has the smallest y, column 0 the
 *  smallest x. Cells are columns of the map's voxels. */
struct LayerFrame
{
	double resolution_m = 0.05;
	Eigen::Vector2i first = Eigen::Vector2i::Zero();  ///< of cell (0, 0): its voxels' numbers x and y, 0 at the origin
	Eigen::Vector2d corner_in_map = Eigen::Vector2d::Zero();  ///< of cell (0, 0): resolution_m · first
	int columns = 0, rows = 0;
	std::vector<double> altitudes_m;  ///< z in the map of each layer, lowest first

	/** The layer with the altitude nearest to `z_m`. */
	[[nodiscard]] int nearestLayer(double z_m) const;
	[[nodiscard]] int layers() const { return static_cast<int>(altitudes_m.size()); }
	[[nodiscard]] std::size_t size() const { return altitudes_m.size() * cellsInLayer(); }
	[[nodiscard]] std::size_t cellsInLayer() const
	{
		return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
	}
	[[nodiscard]] bool holds(const LayerCell& cell) const
	{
		return cell.column >= 0 && cell.column < columns && cell.row >= 0 && cell.row < rows;
	}
	/** Of a cell that the frame holds. */
	[[nodiscard]] std::size_t indexOf(const LayerCell& cell) const
	{
		return (static_cast<std::size_t>(cell.layer) * static_cast<std::size_t>(rows) +
		        static_cast<std::size_t>(cell.row)) *
		           static_cast<std::size_t>(columns) +
		       static_cast<std::size_t>(cell.column);
	}
	[[nodiscard]] LayerCell cellOf(std::size_t index) const;
	/** The cell of the layer that the point is in, whether the frame holds it or not. */
	[[nodiscard]] LayerCell cellAt(const Eigen::Vector2d& point_in_map, int layer) const;
	/** Its index; no value beyond the frame. */
	[[nodiscard]] std::optional<std::size_t> indexAt(const Eigen::Vector2d& point_in_map, int layer) const;
	[[nodiscard]] Eigen::Vector2d centreOf(std::size_t index) const;
};

/** A cell's index in a frame that holds the old one. */
std::size_t movedIndex(std::size_t index, const LayerFrame& old, const LayerFrame& now);

/** One value a cell, moved from the old frame to one that holds it; the others are `rest`. */
template <class Value>
std::vector<Value> movedCells(const std::vector<Value>& cells, const LayerFrame& old, const LayerFrame& now,
                              const Value& rest)
{
	std::vector<Value> moved(now.size(), rest);
	if (old.columns == 0) return moved;
	for (std::size_t from = 0; from < cells.size(); from += static_cast<std::size_t>(old.columns))
		std::copy_n(cells.begin() + static_cast<std::ptrdiff_t>(from), old.columns,
		            moved.begin() + static_cast<std::ptrdiff_t>(movedIndex(from, old, now)));
	return moved;
}
}  // namespace explore
