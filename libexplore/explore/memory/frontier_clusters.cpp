#include <explore/memory/frontier_clusters.h>

#include <cmath>

namespace explore
{
namespace
{
/** Where the cells are, in cells from the frame's corner. */
struct Spread
{
	Eigen::Vector2d mean = Eigen::Vector2d::Zero();
	Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  ///< unit vector along the longest
	double length = 0.0;                              ///< along it, from end to end
};

Eigen::Vector2d placeOf(const LayerFrame& frame, std::size_t index)
{
	const LayerCell cell = frame.cellOf(index);
	return {cell.column, cell.row};
}

Spread spreadOf(const LayerFrame& frame, const std::vector<std::size_t>& cells)
{
	// Seen from the first cell, sums of whole numbers stay exact and do not depend on where the frame begins.
	const Eigen::Vector2d origin = placeOf(frame, cells.front());
	Eigen::Vector2d sum = Eigen::Vector2d::Zero();
	Eigen::Matrix2d products = Eigen::Matrix2d::Zero();
	for (const std::size_t index : cells)
	{
		const Eigen::Vector2d place = placeOf(frame, index) - origin;
		sum += place;
		products += place * place.transpose();
	}
	const auto count = static_cast<double>(cells.size());
	const Eigen::Matrix2d scatter = count * products - sum * sum.transpose();
	Spread spread;
	const double angle_rad = 0.5 * std::atan2(2.0 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
	spread.axis = {std::cos(angle_rad), std::sin(angle_rad)};
	spread.mean = sum / count;
	double low = 0.0, high = 0.0;
	for (const std::size_t index : cells)
	{
		const double along = (placeOf(frame, index) - origin - spread.mean).dot(spread.axis);
		low = std::min(low, along);
		high = std::max(high, along);
	}
	spread.mean += origin;
	spread.length = high - low + 1.0;
	return spread;
}

FrontierCluster described(const BodyLayers& layers, std::vector<std::size_t> cells)
{
	const LayerFrame& frame = layers.frame();
	FrontierCluster cluster;
	Eigen::Vector2i sum = Eigen::Vector2i::Zero(), outward = sum;
	for (const std::size_t index : cells)
	{
		const LayerCell cell = frame.cellOf(index);
		cluster.layer = cell.layer;
		sum += frame.first + Eigen::Vector2i(cell.column, cell.row);
		for (const auto& [column, row] : kSides)
			if (layers.stateOf({cell.column + column, cell.row + row, cell.layer}) == CellState::unknown)
				outward += Eigen::Vector2i(column, row);
	}
	const Eigen::Vector2d mean = sum.cast<double>() / static_cast<double>(cells.size());
	cluster.centroid_in_map = frame.resolution_m * (mean + Eigen::Vector2d::Constant(0.5));
	cluster.outward = outward.cast<double>().normalized();
	cluster.cells = std::move(cells);
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
	const LayerFrame& frame = layers.frame();
	std::vector<FrontierCluster> clusters;
	std::vector<std::vector<std::size_t>> rest{cells};
	while (!rest.empty())
	{
		std::vector<std::size_t> piece = std::move(rest.back());
		rest.pop_back();
		const Spread spread = spreadOf(frame, piece);
		if (piece.size() == 1 || frame.resolution_m * spread.length <= max_length_m)
		{
			clusters.push_back(described(layers, std::move(piece)));
			continue;
		}
		std::vector<std::size_t>& near = rest.emplace_back();
		std::vector<std::size_t> far;
		for (const std::size_t index : piece)
			((placeOf(frame, index) - spread.mean).dot(spread.axis) < 0.0 ? near : far).push_back(index);
		rest.push_back(std::move(far));
	}
	std::ranges::sort(clusters, {}, [](const FrontierCluster& cluster) { return cluster.cells.front(); });
	return clusters;
}
}  // namespace explore
