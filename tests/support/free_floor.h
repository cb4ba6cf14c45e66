// The floor of a world that can be reached from its spawns.
#pragma once

#include "support/building_sketch.h"

#include <explore/simulation/ray_scene.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace explore::test
{
/** Floor cells that can be reached from the spawns on level floor. The scene must outlive it. */
class FreeFloor
{
public:
	explicit FreeFloor(const simulation::RayScene& scene);
	[[nodiscard]] bool empty() const { return m_reached.empty(); }
	[[nodiscard]] bool reached(const Eigen::Vector2d& at) const;
	/** Anywhere on it; it must not be empty. */
	[[nodiscard]] Eigen::Vector2d draw(Dice& dice) const;

private:
	using Cell = std::pair<int, int>;

	static Cell cellOf(const Eigen::Vector2d& at);
	[[nodiscard]] bool isFree(const Cell& cell) const;
	/** Whether the cell was not looked at before and is free. */
	bool visit(const Cell& cell);
	void spread(const Eigen::Vector2d& from);
	/** The nearest free cell about `from`; no value where there is none near or another spawn has been there. */
	[[nodiscard]] std::optional<Cell> startNear(const Eigen::Vector2d& from);

	const simulation::RayScene& m_scene;
	std::map<Cell, bool> m_cells;
	std::vector<Cell> m_reached;
};
}  // namespace explore::test
