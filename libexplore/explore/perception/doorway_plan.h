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
	/** Centres of the cells where something stands: (along, behind) [m]. */
	[[nodiscard]] std::vector<Eigen::Vector2d> obstacles() const;
	/** The greatest height of a point in these cells; 0 where nothing stands. */
	[[nodiscard]] double top_m() const;

private:
	static constexpr float kCell_m = 0.05F;
	struct Cell
	{
		std::int32_t count = 0;
		float along_sum_m = 0, behind_sum_m = 0, top_m = 0;
	};
	[[nodiscard]] bool stands(const Cell& cell) const;

	float m_front_m;
	int m_columns, m_rows, m_enough;
	std::vector<Cell> m_cells;
};
}  // namespace explore
