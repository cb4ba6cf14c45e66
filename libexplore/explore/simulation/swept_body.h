// An upright cylinder on its way through a world: where along a straight path it first touches something.
#pragma once

#include <explore/simulation/ray_scene.h>
#include <explore/simulation/triangle_distance.h>

#include <array>
#include <cstdint>
#include <vector>

namespace explore::simulation
{
/** Collects once what is within reach of a place, then answers for many directions from there. */
class SweptBody
{
public:
	/** Paths of up to `reach_m`, between −`max_elevation_rad` and `max_elevation_rad`. */
	SweptBody(const RayScene& scene, VerticalCylinder body, double reach_m, double max_elevation_rad);

	/** How far [m] the body moves along the azimuth (map frame, positive to the left) and elevation (positive up)
	 * before it touches a surface, at most reach_m; to 10⁻⁴ m. */
	[[nodiscard]] double freePath(double azimuth_rad, double elevation_rad) const;

private:
	struct Obstacle
	{
		Triangle corners;
		double nearest_m = 0;  ///< of its plan view, from the body's axis
		double low_z = 0, high_z = 0;
	};
	struct Direction
	{
		Eigen::Vector2d forward = Eigen::Vector2d::UnitX();
		double rise = 0;  ///< a metre forward
	};
	static constexpr std::size_t kSectors = 72;

	void collect(const RayScene& scene, double max_elevation_rad);
	void sortIntoSectors();
	[[nodiscard]] double contact(const Obstacle& obstacle, const Direction& direction, double limit) const;
	[[nodiscard]] double firstNear(const Obstacle& obstacle, const Direction& direction, double from, double to) const;

	VerticalCylinder m_body;
	double m_reach_m;
	std::vector<Obstacle> m_obstacles;  ///< by nearest_m
	/** Of each range of azimuths those that a path in it may touch, nearest first. */
	std::array<std::vector<std::uint32_t>, kSectors> m_sectors;
};
}  // namespace explore::simulation
