// The things that stand in a doorway, seen from above.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace explore
{
/** Points between the jambs and a little before and behind them, counted in cells. */
class DoorwayPlan
{
public:
	/** `rays_per_cell_m2`: how many rays meet a square metre of upright surface there; what gets far fewer than a low
	 *  thing of a cell's width would is noise. */
	DoorwayPlan(double width_m, double front_m, double behind_m, double rays_per_m2);

	/** along_m from the left jamb, behind_m > 0 behind the wall's plane. */
	void add(float along_m, float behind_m, float height_m);
	/** A ray crosses the doorway's cells from behind_m = 0 at `along_m` to (end_along_m, end_behind_m) and meets
	 * nothing on its way. */
	void addSight(float along_m, float end_along_m, float end_behind_m);
	/** Centres of the cells where something stands: (along, behind) [m]. */
	[[nodiscard]] std::vector<Eigen::Vector2d> obstacles() const;
	/** Width of the widest straight lane through the opening, at one of some angles, in whose cells behind the wall
	 * rays were seen to pass and nothing stands [m]. */
	[[nodiscard]] double seenLane_m() const;
	/** The greatest height of a point in these cells; 0 where nothing stands. */
	[[nodiscard]] double top_m() const;

private:
	static constexpr float kCell_m = 0.05F;
	struct Cell
	{
		std::int32_t count = 0, sights = 0;
		float along_sum_m = 0, behind_sum_m = 0, top_m = 0;
	};
	[[nodiscard]] bool stands(const Cell& cell) const;
	[[nodiscard]] Cell* cellAt(float along_m, float behind_m);
	[[nodiscard]] bool isSeenFree(int column, float per_row) const;

	float m_front_m;
	int m_columns, m_rows, m_enough;
	std::vector<Cell> m_cells;
};
}  // namespace explore
