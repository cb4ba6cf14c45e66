#include <explore/memory/frontier_clusters.h>

#include <cmath>

namespace explore
{
namespace
{
struct PlacedCell
{
	std::size_t index;
	Eigen::Vector2d place;  ///< column and row, from the first cell of the lot on: sums of whole numbers stay exact
};

/** Where cells are, in cells. */
struct Spread
{
	Eigen::Vector2d mean = Eigen::Vector2d::Zero();
	Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  ///< unit vector along the longest
	double length = 0.0;                              ///< along it, from end to end

	[[nodiscard]] double along(const PlacedCell& cell) const { return (cell.place - mean).dot(axis); }
};

std::vector<PlacedCell> placed(const LayerFrame& frame, const std::vector<std::size_t>& cells)
{
	const LayerCell first = frame.cellOf(cells.front());
	std::vector<PlacedCell> all;
	all.reserve(cells.size());
	for (const std::size_t index : cells)
	{
		const LayerCell cell = frame.cellOf(index);
		all.push_back({index, {cell.column - first.column, cell.row - first.row}});
	}
	return all;
}

Spread spreadOf(const std::vector<PlacedCell>& cells)
{
	Eigen::Vector2d sum = Eigen::Vector2d::Zero();
	Eigen::Matrix2d products = Eigen::Matrix2d::Zero();
	for (const PlacedCell& cell : cells)
	{
		sum += cell.place;
		products += cell.place * cell.place.transpose();
	}
	const auto count = static_cast<double>(cells.size());
	const Eigen::Matrix2d scatter = count * products - sum * sum.transpose();
	Spread spread;
	const double angle_rad = 0.5 * std::atan2(2.0 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
	spread.axis = {std::cos(angle_rad), std::sin(angle_rad)};
	spread.mean = sum / count;
	double low = 0.0, high = 0.0;
	for (const PlacedCell& cell : cells)
	{
		low = std::min(low, spread.along(cell));
		high = std::max(high, spread.along(cell));
	}
	spread.length = high - low + 1.0;
	return spread;
}

FrontierCluster described(const BodyLayers& layers, const std::vector<PlacedCell>& cells)
{
	const LayerFrame& frame = layers.frame();
	FrontierCluster cluster;
	Eigen::Vector2i sum = Eigen::Vector2i::Zero(), outward = sum;
	cluster.cells.reserve(cells.size());
	for (const PlacedCell& placed : cells)
	{
		cluster.cells.push_back(placed.index);
		const LayerCell cell = frame.cellOf(placed.index);
		cluster.layer = cell.layer;
		sum += frame.first + Eigen::Vector2i(cell.column, cell.row);
		for (const auto& [column, row] : kSides)
			if (layers.stateOf({cell.column + column, cell.row + row, cell.layer}) == CellState::unknown)
				outward += Eigen::Vector2i(column, row);
	}
	const Eigen::Vector2d mean = sum.cast<double>() / static_cast<double>(cells.size());
	cluster.centroid_in_map = frame.resolution_m * (mean + Eigen::Vector2d::Constant(0.5));
	cluster.outward = outward.cast<double>().normalized();
	return cluster;
}
}  // namespace

bool isFrontier(const BodyLayers& layers, const LayerCell& cell)
{
	if (layers.stateOf(cell) != CellState::free) return false;
	return std::ranges::any_of(
	    kSides,
	    [&](const auto& side) {
		    return layers.stateOf({cell.column + side[0], cell.row + side[1], cell.layer}) == CellState::unknown;
	    });
}

std::vector<FrontierCluster> clustersOf(const BodyLayers& layers, const std::vector<std::size_t>& cells,
                                        double max_length_m)
{
	const double max_length = max_length_m / layers.frame().resolution_m;
	std::vector<FrontierCluster> clusters;
	std::vector<std::vector<PlacedCell>> rest{placed(layers.frame(), cells)};
	while (!rest.empty())
	{
		const std::vector<PlacedCell> piece = std::move(rest.back());
		rest.pop_back();
		const Spread spread = spreadOf(piece);
		if (piece.size() == 1 || spread.length <= max_length)
		{
			clusters.push_back(described(layers, piece));
			continue;
		}
		std::vector<PlacedCell> near, far;
		for (const PlacedCell& cell : piece) (spread.along(cell) < 0.0 ? near : far).push_back(cell);
		rest.push_back(std::move(near));
		rest.push_back(std::move(far));
	}
	std::ranges::sort(clusters, {}, [](const FrontierCluster& cluster) { return cluster.cells.front(); });
	return clusters;
}
}  // namespace explore
