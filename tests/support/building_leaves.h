// Where the leaves of an opening, its jambs, stops and casings stand on the plan, and how much they leave free.
#pragma once

#include "support/building_opening.h"

#include <array>
#include <vector>

namespace explore::test
{
/** A rectangle on the floor plan: corners in order. */
using Footprint = std::array<Eigen::Vector2d, 4>;

inline constexpr double kLeaf_m = 0.04;   ///< thickness of a leaf
inline constexpr double kSlit_m = 0.003;  ///< leaves leave at most this much between them and their frame

/** Wall axes from those of a leaf: u from its hinge jamb into the opening, v out of the face that it belongs to. */
struct LeafAxes
{
	double jamb_x;
	double u_sign, v_sign;
	[[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& leaf) const
	{
		return {jamb_x + u_sign * leaf.x(), v_sign * leaf.y()};
	}
};
LeafAxes axesOf(const Opening& opening, bool at_start);
Footprint rectangle(const LeafAxes& axes, const Eigen::Vector2d& low, const Eigen::Vector2d& high);

/** What is left beside a bolted leaf; any other opening as it is. */
Opening movingPartOf(const Opening& opening);
/** Where the leaves stand, wall axes: x from the wall's start, y to its left. Empty for an opening without. */
std::vector<Footprint> leavesOf(const Opening& opening, double thickness_m);
/** The diameter of the widest upright disc that gets past leaves, stops, casings and walls across (no people or boxes).
 */
double clearWidthOf(const Opening& opening, double thickness_m);
/** Distance of two convex footprints; 0 where they overlap. */
double distanceOf(const Footprint& a, const Footprint& b);
}  // namespace explore::test
