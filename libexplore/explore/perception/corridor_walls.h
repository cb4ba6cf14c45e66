// Two walls that face each other: their common direction, fitted to all points of all walls that run along with them.
#pragma once

#include <explore/perception/corridor_points.h>

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace explore
{
/** A wall at the camera's left and one at its right that run along `direction`; the camera stands between their planes.
 */
struct FacingWalls
{
	Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit, level frame, to the side the camera looks to
	double sigma_rad = 0;                                  ///< of the direction
	double left_m = 0, right_m = 0;                        ///< distances of the planes from the camera, both positive
	std::size_t left = 0, right = 0;                       ///< places in the list of walls
	std::vector<std::size_t> agreeing;                     ///< all walls that run along with them, they included

	[[nodiscard]] double width_m() const { return left_m + right_m; }
};

/** Unit, horizontal, to the left of `direction`. */
[[nodiscard]] inline Eigen::Vector2d leftOf(const Eigen::Vector2d& direction)
{
	return {-direction.y(), direction.x()};
}

/** The wall's axis on the side that the camera looks to (level x ≥ 0). */
[[nodiscard]] Eigen::Vector2d forwardAxis(const UprightWall& wall);

/** Angle in [0, π/2] between two axes of the plan view. */
[[nodiscard]] double angleBetween(const Eigen::Vector2d& axis_a, const Eigen::Vector2d& axis_b);

/** From where to where a wall is seen along a direction, 0 = the camera [m]. */
struct WallExtent
{
	double from_m, to_m;
};
[[nodiscard]] WallExtent extentAlong(const UprightWall& wall, const Eigen::Vector2d& direction);

/** What two walls must be like to face each other. */
struct FacingConfig
{
	double min_width_m, max_width_m;
	double parallel_rad;  ///< largest angle between walls as they were found one by one
};

/** All pairs of walls that face each other, with the mean of their directions, weighted by what each says of it, and
 * the walls that run along with them within `parallel_rad`. */
std::vector<FacingWalls> facingWalls(const std::vector<UprightWall>& walls, const FacingConfig& config);

/** Makes direction and distances fit the points of the agreeing walls best: one slope for all of them, each at its own
 *  distance, points weighted by 1/σ² across their wall, walls that contradict the rest left out. Least squares in
 *  rounds; a round takes the points within the walls' tolerance. */
void fitJointly(FacingWalls& pair, const std::vector<UprightWall>& walls, const PlanPoints& points,
                const UprightWallConfig& config);
}  // namespace explore
