// The coverage of a map while it grows, counted on from the voxels that change.
#pragma once

#include <explore/core/truth.h>
#include <explore/evaluation/coverage.h>
#include <explore/memory/frontier_memory.h>

#include <cstdint>
#include <vector>

namespace explore::evaluation
{
/** What coverageOf() says of the same map, at the cost of the changes alone. The middles of cells must not lie between
 *  voxels: cells of the voxels' size, or of an odd multiple. Memory: 4 bytes a cell and level. */
class CoverageCount
{
public:
	explicit CoverageCount(TruthReach reach) : m_reach(std::move(reach)) {}

	/** Takes over what the last frame changed in the memory's map; begins with all of the map, and does so again where
	 *  frames were missed. Always the same memory. */
	void follow(FrontierMemory& memory);
	/** Of the map at the last call; without one nothing is covered. */
	[[nodiscard]] Coverage coverage() const;
	[[nodiscard]] const TruthReach& reach() const { return m_reach; }

private:
	/** How many voxels there are of a kind above a cell's middle, in its level. */
	struct Counts
	{
		std::int16_t free = 0, occupied = 0;
		[[nodiscard]] bool covered() const { return free > 0 && occupied == 0; }
	};

	void begin(const octomap::OcTree& map);
	/** Counts voxels in (`sign` 1) or out again (−1). */
	void include(const KeyBox& voxels, VoxelState state, int sign);
	/** Columns or rows whose middles are in these voxels. */
	[[nodiscard]] KeyRange cellsAt(const KeyRange& voxels, int first, int count) const;

	TruthReach m_reach;
	double m_resolution_m = 0.05;
	std::vector<KeyRange> m_heights;  ///< of each level
	std::vector<std::vector<Counts>> m_counts;
	std::size_t m_covered = 0;
	std::uint64_t m_revision = 0;  ///< of the memory's layers, which follow the same changes
};
}  // namespace explore::evaluation
