// Where the space that a robot may move in ends at unknown space, kept up to date from the changed cells alone.
#pragma once

#include <explore/memory/frontier_clusters.h>

#include <vector>

namespace explore
{
struct FrontierConfig
{
	double max_length_m = 1.5;  ///< of a cluster, from end to end
};
/** [frontiers] */
void describe(FieldVisitor& fields, FrontierConfig& config);

/** A frontier is a free cell with an unknown one beside it, in the same layer. Those that touch, corners included, are
 *  cut into clusters. After each update() all is as if it were worked out anew from all cells.
 *
 *  Memory: 1 byte a cell. */
class Frontiers
{
public:
	explicit Frontiers(const FrontierConfig& config = {}) : m_config(config) {}

	/** Takes over what the layers' last update() or rebuild() changed; looks at all cells where calls were missed in
	 *  between. Always the same layers. */
	void update(const BodyLayers& layers);

	/** Layer after layer, in order of their first cells; indices of cells are those of the layers at the last update().
	 */
	[[nodiscard]] const std::vector<FrontierCluster>& clusters() const { return m_clusters; }
	/** Of a cell's index. */
	[[nodiscard]] bool isFrontier(std::size_t cell) const { return (m_flags[cell] & kFrontier) != 0; }

private:
	static constexpr std::uint8_t kFrontier = 1, kGathered = 2;

	void follow(const LayerFrame& frame);
	void look(const BodyLayers& layers, const LayerCell& cell);
	void gather(const LayerCell& start);
	void addClusters(const BodyLayers& layers);

	FrontierConfig m_config;
	LayerFrame m_frame;
	std::uint64_t m_revision = 0;
	std::vector<std::uint8_t> m_flags;  ///< of each cell
	std::vector<FrontierCluster> m_clusters;
	std::vector<LayerCell> m_touched;                  ///< cells that are or were frontier, beside a changed one
	std::vector<std::vector<std::size_t>> m_gathered;  ///< cells that touch, to be clustered anew
};
}  // namespace explore
