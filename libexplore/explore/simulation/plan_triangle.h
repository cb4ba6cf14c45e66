// A triangle seen from above: at which heights it stands within a circle of the floor plan.
#pragma once

#include <explore/simulation/triangle_distance.h>
#include <explore/simulation/world.h>

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
		double from_z = 0, along_z = 0, length2 = 0;
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

/** Each triangle of what stands still, as it is; those with a corner that is not finite are left out. */
template <class Visit>
void forEachTriangle(const World& world, const Visit& visit)
{
	for (const auto& corners : world.mesh.triangles)
	{
		Triangle triangle;
		for (std::size_t i = 0; i < 3; ++i) triangle[i] = world.mesh.vertices[corners[i]].cast<double>();
		if (triangle[0].allFinite() && triangle[1].allFinite() && triangle[2].allFinite()) visit(triangle);
	}
}

/** Height of the highest surface that stands still below a place; no value where there is none. */
std::optional<double> surfaceBelow(const World& world, const Eigen::Vector3d& place_in_map);
}  // namespace explore::simulation
