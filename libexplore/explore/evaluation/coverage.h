// How much of what a robot can get to its map shows as free.
#pragma once

#include <explore/core/truth.h>
#include <explore/memory/floor_map.h>

#include <cstddef>

namespace explore::evaluation
{
struct Coverage
{
	std::size_t reachable = 0, covered = 0;  ///< cells

	/** covered / reachable; 1 where nothing is reachable. */
	[[nodiscard]] double share() const;
};

/** A reachable cell is covered where, between the heights of its level, `map` has something free and nothing occupied
 *  above the cell's middle (doc/definitions.md, "Covered"). Of a MAV's level that is the voxel there. */
Coverage coverageOf(const TruthReach& reach, const octomap::OcTree& map);
}  // namespace explore::evaluation
