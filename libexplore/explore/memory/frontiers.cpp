#include <explore/memory/frontiers.h>

namespace explore
{
void describe(FieldVisitor& fields, FrontierConfig& config)
{
	fields.section("frontiers", "Where the space that the robot may move in ends at unknown space.");
	fields.real("max_length", config.max_length_m, {0.2, 20.0}, "m",
	            "Longer stretches of frontier are cut, so that each can be looked at from one place.");
}

void Frontiers::follow(const LayerFrame& frame)
{
	if (frame.size() == m_frame.size() && frame.first == m_frame.first) return;
	m_flags = movedCells(m_flags, m_frame, frame, std::uint8_t{0});
	for (FrontierCluster& cluster : m_clusters)
		for (std::size_t& cell : cluster.cells) cell = movedIndex(cell, m_frame, frame);
	m_frame = frame;
}

void Frontiers::update(const BodyLayers& layers)
{
	follow(layers.frame());
	const auto look_around = [&](std::size_t index)
	{
		const LayerCell cell = m_frame.cellOf(index);
		look(layers, cell);
		for (const auto& [column, row] : kSides) look(layers, {cell.column + column, cell.row + row, cell.layer});
	};
	if (layers.revision() == m_revision + 1)
		for (const std::size_t index : layers.changedCells()) look_around(index);
	else
		for (std::size_t index = 0; index < m_frame.size(); ++index) look_around(index);
	m_revision = layers.revision();
	for (const LayerCell& cell : m_touched)
		for (int row = cell.row - 1; row <= cell.row + 1; ++row)
			for (int column = cell.column - 1; column <= cell.column + 1; ++column) gather({column, row, cell.layer});
	m_touched.clear();
	addClusters(layers);
}

void Frontiers::look(const BodyLayers& layers, const LayerCell& cell)
{
	if (!m_frame.holds(cell)) return;
	std::uint8_t& flags = m_flags[m_frame.indexOf(cell)];
	const std::uint8_t now = explore::isFrontier(layers, cell) ? kFrontier : 0;
	// One that stays may have other unknown neighbours than before: its cluster is described anew.
	if ((flags | now) != 0) m_touched.push_back(cell);
	flags = now;
}

void Frontiers::gather(const LayerCell& start)
{
	const auto is_new = [&](const LayerCell& cell)
	{ return m_frame.holds(cell) && m_flags[m_frame.indexOf(cell)] == kFrontier; };
	if (!is_new(start)) return;
	std::vector<std::size_t> cells{m_frame.indexOf(start)};
	m_flags[cells.front()] |= kGathered;
	for (std::size_t done = 0; done < cells.size(); ++done)
	{
		const LayerCell cell = m_frame.cellOf(cells[done]);
		for (int row = cell.row - 1; row <= cell.row + 1; ++row)
			for (int column = cell.column - 1; column <= cell.column + 1; ++column)
			{
				const LayerCell beside{column, row, cell.layer};
				if (!is_new(beside)) continue;
				cells.push_back(m_frame.indexOf(beside));
				m_flags[cells.back()] |= kGathered;
			}
	}
	std::ranges::sort(cells);
	m_gathered.push_back(std::move(cells));
}

void Frontiers::addClusters(const BodyLayers& layers)
{
	const auto first_cell = [](const FrontierCluster& cluster) { return cluster.cells.front(); };
	// What an old cluster belonged to has lost cells, which leaves the first of them or gathers it, or is as it was.
	std::erase_if(m_clusters,
	              [&](const FrontierCluster& cluster) { return m_flags[first_cell(cluster)] != kFrontier; });
	const auto kept = std::ssize(m_clusters);
	for (const std::vector<std::size_t>& cells : m_gathered)
	{
		for (const std::size_t cell : cells) m_flags[cell] = kFrontier;
		for (FrontierCluster& cluster : clustersOf(layers, cells, m_config.max_length_m))
			m_clusters.push_back(std::move(cluster));
	}
	m_gathered.clear();
	const auto added = m_clusters.begin() + kept;
	std::ranges::sort(added, m_clusters.end(), {}, first_cell);
	std::ranges::inplace_merge(m_clusters, added, {}, first_cell);
}
}  // namespace explore
