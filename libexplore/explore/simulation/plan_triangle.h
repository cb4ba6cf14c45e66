// A triangle seen from above: at which heights it stands within a circle of the floor plan.
#pragma once

#include <explore/simulation/triangle_distance.h>

#include <Eigen/Core>
#include <array>
#include <optional>

namespace explore::simulation
{
/** Both ends included. */
struct Heights
{
	double low_m = 0, high_m = 0;
};

/** Made once for many circles. */
class PlanTriangle
{
public:
	explicit PlanTriangle(const Triangle& triangle);

	/** Heights of the part of the triangle on or within the circle, which has no gaps; no value where there is none.
	 * With a radius of 0, the height of a triangle that is not upright at that place. */
	[[nodiscard]] std::optional<Heights> within(const Eigen::Vector2d& center, double radius_m) const;

private:
	struct Edge
	{
		Eigen::Vector2d from, along;
		double from_z, along_z, length2;
	};
	/** The ends of the edge's part within the circle. */
	template <class Add>
	static void addEnds(const Edge& edge, const Eigen::Vector2d& center, double radius2, const Add& add);
	[[nodiscard]] bool covers(const Eigen::Vector2d& place) const;

	std::array<Edge, 3> m_edges;
	bool m_upright;              ///< has no area on the floor plan
	Eigen::Vector2d m_slope;     ///< of its plane, where it has one: z grows by that along x and y
	Eigen::Vector2d m_steepest;  ///< unit vector up the slope; zero where it is level
};
}  // namespace explore::simulation
