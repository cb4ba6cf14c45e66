// The floor plan in one grid of small numbers, and what changes in it from one time to another.
#pragma once

#include <explore/memory/frontier_memory.h>

#include <string>
#include <vector>

namespace explore
{
enum class PlanCell : std::uint8_t
{
	unknown,
	free,
	occupied,
	drop,
	frontier,  ///< free, at the border of the unknown
};

/** Cells as large as the map's; (column, row) is at row · columns + column, row 0 at the smallest y, column 0 at the
 *  smallest x. Cell (0, 0) begins at cell_m · (first_x, first_y) in the map. */
struct PlanGrid
{
	double cell_m = 0.05;
	int first_x = 0, first_y = 0, columns = 0, rows = 0;
	std::vector<PlanCell> cells;
	bool operator==(const PlanGrid&) const = default;
};

/** Of several layers (a MAV's) a cell is the first of frontier, free, drop and occupied that it is in any of them. */
PlanGrid planGridOf(const FrontierMemory& memory);

/** What takes a grid to a later one that covers it: pairs of numbers, row by row through the later grid: how many cells
 *  stay as they are, then 8 · (how many follow that are new) + the PlanCell that they have become. Each number 7 bits a
 *  byte, lowest first, the top bit set where more follow. What the earlier grid does not cover was unknown. Throws
 *  std::invalid_argument where `to` does not cover `from`. */
std::string planChanges(const PlanGrid& from, const PlanGrid& to);
/** The later grid, whose place and size `to` has already. Throws std::invalid_argument where the changes are of no such
 *  grid. */
void applyPlanChanges(const PlanGrid& from, const std::string& changes, PlanGrid& to);
}  // namespace explore
