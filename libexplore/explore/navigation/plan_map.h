// The planner's view of the body layers: where the robot fits, where it might, and what is unknown there.
#pragma once

#include <explore/memory/body_layers.h>
#include <explore/navigation/keep_out.h>
#include <explore/navigation/plan_config.h>

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace explore
{
/** Number of a cell, layer-major as in BodyLayers::cells(). */
using CellIndex = std::uint32_t;
inline constexpr CellIndex kNoCell = std::numeric_limits<CellIndex>::max();

/** All by cell. */
struct PlanMap
{
	LayerFrame frame;
	double fit_m = 0;  ///< how far from obstacles the robot's centre has to fit for space to be explored
	std::vector<CellState> cells;
	std::vector<float> obstacle_m;          ///< from the cell's middle to the nearest occupied one or drop, capped
	std::vector<std::uint8_t> allowed;      ///< inside the bounds and not kept out
	std::vector<std::uint8_t> passable;     ///< allowed, and all that the body covers is known and free, or was so
	std::vector<std::uint8_t> blocked;      ///< passable by the map, but the robot was stopped there lately
	std::vector<std::uint8_t> wanted;       ///< unknown, and the body might get there and fit
	std::vector<std::uint8_t> near_wanted;  ///< joined to the robot by free cells, with such an unknown one beside it

	[[nodiscard]] std::size_t layerCells() const
	{
		return static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
	}
	/** Column, row and layer. */
	[[nodiscard]] Eigen::Array3i placeOf(CellIndex cell) const;
	[[nodiscard]] bool contains(const Eigen::Array3i& place) const;
	[[nodiscard]] CellIndex cellAt(const Eigen::Array3i& place) const;
	/** The cell of a point in the layer of the nearest altitude; kNoCell outside. */
	[[nodiscard]] CellIndex cellOf(const Eigen::Vector3d& point_in_map) const;
	/** A cell's middle; z is its layer's altitude. */
	[[nodiscard]] Eigen::Vector3d middleOf(CellIndex cell) const;
};

/** The four cells beside it in its layer: visit(cell). */
template <class Visit>
void forEachBeside(const PlanMap& map, CellIndex cell, const Visit& visit)
{
	const auto columns = static_cast<CellIndex>(map.frame.columns), rows = static_cast<CellIndex>(map.frame.rows);
	const CellIndex column = cell % columns, row = cell / columns % rows;
	if (column + 1 < columns) visit(cell + 1);
	if (column > 0) visit(cell - 1);
	if (row + 1 < rows) visit(cell + columns);
	if (row > 0) visit(cell - columns);
}

/** The cells beside it, above and below too: visit(cell). */
template <class Visit>
void forEachNext(const PlanMap& map, CellIndex cell, const Visit& visit)
{
	forEachBeside(map, cell, visit);
	const auto layer = static_cast<CellIndex>(map.layerCells());
	if (cell >= layer) visit(cell - layer);
	if (cell + layer < map.cells.size()) visit(cell + layer);
}

/** What a plan starts from. */
struct PlanInput
{
	const BodyLayers& layers;
	const AllowedArea& area;
	Eigen::Vector3d robot_in_map = Eigen::Vector3d::Zero();  ///< what it might reach begins there
	std::vector<Eigen::Vector3d> trail_in_map;               ///< places where it has been: it fits there
	std::vector<Eigen::Vector3d> blocked_in_map;             ///< spots where it was stopped, each as often as it was
};
PlanMap planMap(const PlanInput& input, const RobotConfig& robot, const PlanConfig& config);

/** Whether the straight way between two cells of a layer is passable and not blocked, and nowhere nearer to obstacles
 *  than `clearance_m`. */
bool straightWayIsFree(const PlanMap& map, CellIndex from, CellIndex to, double clearance_m);
}  // namespace explore
