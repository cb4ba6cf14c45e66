#include <explore/evaluation/coverage_count.h>

#include <cmath>

namespace explore::evaluation
{
KeyRange CoverageCount::cellsAt(const KeyRange& voxels, int first, int count) const
{
	// A middle is (number + 0.5) · cell_m from the map's origin.
	const double low_m = (voxels.first - kOriginKey) * m_resolution_m;
	const double high_m = (voxels.last + 1 - kOriginKey) * m_resolution_m;
	constexpr double kRounding = 1e-6;
	const KeyRange cells{static_cast<int>(std::ceil(low_m / m_reach.cell_m - 0.5 - kRounding)) - first,
	                     static_cast<int>(std::ceil(high_m / m_reach.cell_m - 0.5 - kRounding)) - 1 - first};
	return cells.common({0, count - 1});
}

void CoverageCount::include(const KeyBox& voxels, VoxelState state, int sign)
{
	if (state == VoxelState::unknown) return;
	const KeyRange columns = cellsAt(voxels.x, m_reach.first_column, m_reach.columns);
	const KeyRange rows = cellsAt(voxels.y, m_reach.first_row, m_reach.rows);
	if (columns.size() == 0 || rows.size() == 0) return;
	for (std::size_t level = 0; level < m_heights.size(); ++level)
	{
		const int count = sign * voxels.z.common(m_heights[level]).size();
		if (count == 0) continue;
		for (int row = rows.first; row <= rows.last; ++row)
			for (int column = columns.first; column <= columns.last; ++column)
			{
				const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(m_reach.columns) +
				                  static_cast<std::size_t>(column);
				if (m_reach.levels[level].reachable[cell] == 0) continue;
				Counts& counts = m_counts[level][cell];
				const bool before = counts.covered();
				std::int16_t& kind = state == VoxelState::free ? counts.free : counts.occupied;
				kind = static_cast<std::int16_t>(kind + count);
				if (counts.covered() && !before) ++m_covered;
				if (before && !counts.covered()) --m_covered;
			}
	}
}

void CoverageCount::begin(const octomap::OcTree& map)
{
	m_resolution_m = map.getResolution();
	m_heights.clear();
	m_counts.clear();
	m_covered = 0;
	const std::size_t cells = static_cast<std::size_t>(m_reach.columns) * static_cast<std::size_t>(m_reach.rows);
	for (const TruthReach::Level& level : m_reach.levels)
	{
		m_heights.push_back(keysBetween(level.low_m, level.high_m, m_resolution_m));
		m_counts.emplace_back(cells);
	}
	forEachLeaf(map, [&](const KeyBox& leaf, bool occupied)
	            { include(leaf, occupied ? VoxelState::occupied : VoxelState::free, 1); });
}

void CoverageCount::follow(FrontierMemory& memory)
{
	const std::uint64_t revision = memory.layers.revision();
	if (m_counts.size() != m_reach.levels.size() || revision > m_revision + 1)
		begin(memory.map.tree());
	else if (revision == m_revision + 1)
		for (const VoxelChange& change : memory.map.changes())
		{
			const KeyBox voxel{
			    {change.key[0], change.key[0]}, {change.key[1], change.key[1]}, {change.key[2], change.key[2]}};
			include(voxel, change.before, -1);
			include(voxel, change.after, 1);
		}
	m_revision = revision;
}

Coverage CoverageCount::coverage() const
{
	return {m_reach.cells(), m_covered};
}
}  // namespace explore::evaluation
