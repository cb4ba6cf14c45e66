// Cells of the reachable space: their places, and which of the free ones are connected to a start.
#pragma once

#include <explore/core/truth.h>

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace explore::simulation
{
/** One byte a cell of a level, in the order of TruthReach::Level::reachable. */
using CellBytes = std::vector<std::uint8_t>;

struct ReachCell
{
	int column, row, level;
};

/** Place of the cell in CellBytes. */
[[nodiscard]] std::size_t planIndex(const TruthReach& reach, int column, int row);
/** Also outside of `reach`. Of one level all heights are in it. */
[[nodiscard]] ReachCell cellAt(const TruthReach& reach, const Eigen::Vector3d& point_in_map);
[[nodiscard]] bool isInside(const TruthReach& reach, const ReachCell& cell);

/** Marks as reachable what is connected to the cell of `start_in_map` over sides of cells that are not blocked (0).
 * Where that cell is blocked, the nearest free one of its level within 0.3 m is the start; without one nothing is
 * marked. */
void spread(TruthReach& reach, std::vector<CellBytes> blocked, const Eigen::Vector3d& start_in_map);
}  // namespace explore::simulation
