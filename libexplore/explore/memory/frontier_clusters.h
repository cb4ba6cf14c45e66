// Pieces of frontier, short enough to be looked at from one place.
#pragma once

#include <explore/memory/body_layers.h>

#include <array>
#include <vector>

namespace explore
{
struct FrontierCluster
{
	std::vector<std::size_t> cells;  ///< indices in the layers' frame, ascending
	int layer = 0;
	Eigen::Vector2d centroid_in_map = Eigen::Vector2d::Zero();  ///< mean of the cells' centres; perhaps in none of them
	/** Unit vector into the unknown, the mean over all sides of cells that border on it; zero where they cancel. */
	Eigen::Vector2d outward = Eigen::Vector2d::Zero();
};

/** The sides on which a cell has neighbours, as steps of (column, row). */
constexpr std::array<std::array<int, 2>, 4> kSides{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/** Frontier: free, and unknown on one side at least. */
bool isFrontier(const BodyLayers& layers, const LayerCell& cell);

/** Cuts cells of one layer, ascending and one at least, across their longest axis (that of their principal component)
 *  at their mean, and the pieces again, until each is at most max_length_m from end to end along its own or one cell
 *  (as Zhou et al. 2021, "FUEL", §IV-B). Pieces are in order of their first cells. */
std::vector<FrontierCluster> clustersOf(const BodyLayers& layers, const std::vector<std::size_t>& cells,
                                        double max_length_m);
}  // namespace explore
