// Lines in the plan view's scan: the straight upright surfaces.
#pragma once

#include <explore/perception/plan_line.h>

#include <vector>

namespace explore
{
struct WallLine
{
	PlanLine line;
	std::vector<int> members;  ///< indices into the scan, ascending
};

/** Lines with the most samples first, each from the points that the ones before left. Deterministic. */
std::vector<WallLine> findLines(const PlanScan& scan, const UprightWallConfig& config, unsigned seed);
}  // namespace explore
