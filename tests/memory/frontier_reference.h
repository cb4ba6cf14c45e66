// Frontiers of layers worked out anew from all cells: slow and obvious.
#pragma once

#include <explore/memory/frontiers.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <set>

namespace explore::test
{
inline std::set<std::size_t> frontierReference(const BodyLayers& layers)
{
	std::set<std::size_t> frontier;
	const LayerFrame& frame = layers.frame();
	for (int layer = 0; layer < frame.layers(); ++layer)
		for (int row = 0; row < frame.rows; ++row)
			for (int column = 0; column < frame.columns; ++column)
			{
				const auto is = [&](int x, int y, CellState state) {
					return layers.stateOf({column + x, row + y, layer}) == state;
				};
				const bool at_unknown = is(1, 0, CellState::unknown) || is(-1, 0, CellState::unknown) ||
				                        is(0, 1, CellState::unknown) || is(0, -1, CellState::unknown);
				if (is(0, 0, CellState::free) && at_unknown) frontier.insert(frame.indexOf({column, row, layer}));
			}
	return frontier;
}

/** The cells that touch, corners included. */
inline std::vector<std::set<std::size_t>> componentsOf(std::set<std::size_t> cells, const LayerFrame& frame)
{
	std::vector<std::set<std::size_t>> components;
	while (!cells.empty())
	{
		std::set<std::size_t>& component = components.emplace_back();
		std::vector<std::size_t> next{*cells.begin()};
		while (!next.empty())
		{
			const std::size_t index = next.back();
			next.pop_back();
			if (cells.erase(index) == 0) continue;
			component.insert(index);
			const LayerCell at = frame.cellOf(index);
			for (const int row : {-1, 0, 1})
				for (const int column : {-1, 0, 1})
					if (const LayerCell beside{at.column + column, at.row + row, at.layer}; frame.holds(beside))
						next.push_back(frame.indexOf(beside));
		}
	}
	return components;
}

/** From end to end along the principal component, cells included [m]. */
inline double lengthOf(const std::vector<std::size_t>& cells, const LayerFrame& frame)
{
	Eigen::Matrix2Xd at(2, cells.size());
	for (Eigen::Index i = 0; i < at.cols(); ++i) at.col(i) = frame.centreOf(cells[static_cast<std::size_t>(i)]);
	at.colwise() -= at.rowwise().mean().eval();
	const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(at * at.transpose());
	const Eigen::RowVectorXd along = axes.eigenvectors().col(1).transpose() * at;
	return along.maxCoeff() - along.minCoeff() + frame.resolution_m;
}

/** Whether the axis is settled: of a round set any is the longest. */
inline bool hasLongestAxis(const std::vector<std::size_t>& cells, const LayerFrame& frame)
{
	Eigen::Matrix2Xd at(2, cells.size());
	for (Eigen::Index i = 0; i < at.cols(); ++i) at.col(i) = frame.centreOf(cells[static_cast<std::size_t>(i)]);
	at.colwise() -= at.rowwise().mean().eval();
	const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(at * at.transpose());
	return axes.eigenvalues()[1] > 1.0001 * axes.eigenvalues()[0] + 1e-9;
}

inline void expectDescribed(const FrontierCluster& cluster, const BodyLayers& layers)
{
	Eigen::Vector2d centroid = Eigen::Vector2d::Zero(), outward = centroid;
	for (const std::size_t index : cluster.cells)
	{
		const LayerCell at = layers.frame().cellOf(index);
		EXPECT_EQ(at.layer, cluster.layer);
		centroid += layers.frame().centreOf(index);
		const auto unknown = [&](int x, int y) {
			return layers.stateOf({at.column + x, at.row + y, at.layer}) == CellState::unknown ? 1.0 : 0.0;
		};
		outward += Eigen::Vector2d(unknown(1, 0) - unknown(-1, 0), unknown(0, 1) - unknown(0, -1));
	}
	centroid /= static_cast<double>(cluster.cells.size());
	EXPECT_LT((cluster.centroid_in_map - centroid).norm(), 1e-9);
	const double sum = outward.norm();
	EXPECT_LT((cluster.outward - (sum > 0 ? Eigen::Vector2d(outward / sum) : outward)).norm(), 1e-9);
}

/** Clusters hold every frontier cell once, none reaches over two components or is too long, and a component that is
 *  short enough is one cluster. */
inline void expectClusters(const Frontiers& frontiers, const BodyLayers& layers, double max_length_m)
{
	const std::set<std::size_t> expected = frontierReference(layers);
	std::set<std::size_t> clustered;
	std::size_t cells = 0, last_first = 0;
	for (const FrontierCluster& cluster : frontiers.clusters())
	{
		ASSERT_FALSE(cluster.cells.empty());
		EXPECT_TRUE(std::ranges::is_sorted(cluster.cells));
		EXPECT_TRUE(cells == 0 || cluster.cells.front() > last_first) << "out of order";
		last_first = cluster.cells.front();
		clustered.insert(cluster.cells.begin(), cluster.cells.end());
		cells += cluster.cells.size();
		if (hasLongestAxis(cluster.cells, layers.frame()))
		{
			EXPECT_LE(lengthOf(cluster.cells, layers.frame()), max_length_m + 1e-6);
		}
		expectDescribed(cluster, layers);
	}
	ASSERT_EQ(clustered, expected);
	EXPECT_EQ(cells, expected.size()) << "a cell is in two clusters";
	for (const std::set<std::size_t>& component : componentsOf(expected, layers.frame()))
	{
		const auto inside = [&](const FrontierCluster& cluster) { return component.contains(cluster.cells.front()); };
		std::size_t in_clusters = 0;
		for (const FrontierCluster& cluster : frontiers.clusters())
			if (inside(cluster)) in_clusters += cluster.cells.size();
		EXPECT_EQ(in_clusters, component.size()) << "a cluster reaches over two components";
		const std::vector<std::size_t> all(component.begin(), component.end());
		if (!hasLongestAxis(all, layers.frame())) continue;
		const bool is_short = lengthOf(all, layers.frame()) <= max_length_m - 1e-6;
		EXPECT_TRUE(!is_short || std::ranges::count_if(frontiers.clusters(), inside) == 1);
	}
}

inline void expectSame(const Frontiers& frontiers, const Frontiers& other)
{
	ASSERT_EQ(frontiers.clusters().size(), other.clusters().size());
	for (std::size_t i = 0; i < frontiers.clusters().size(); ++i)
	{
		const FrontierCluster &a = frontiers.clusters()[i], &b = other.clusters()[i];
		EXPECT_EQ(a.cells, b.cells);
		EXPECT_EQ(a.layer, b.layer);
		EXPECT_EQ(a.centroid_in_map, b.centroid_in_map);
		EXPECT_EQ(a.outward, b.outward);
	}
}

/** What is kept up to date is, to the last bit, what is worked out anew, and that is right. */
inline void expectUpToDate(const Frontiers& frontiers, const BodyLayers& layers, double max_length_m)
{
	Frontiers anew({.max_length_m = max_length_m});
	anew.update(layers);
	expectSame(frontiers, anew);
	expectClusters(frontiers, layers, max_length_m);
	const std::set<std::size_t> expected = frontierReference(layers);
	for (std::size_t cell = 0; cell < layers.cells().size(); ++cell)
		ASSERT_EQ(frontiers.isFrontier(cell), expected.contains(cell));
}
}  // namespace explore::test
