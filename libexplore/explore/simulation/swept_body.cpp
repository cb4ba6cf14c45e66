#include <explore/core/geometry.h>
#include <explore/simulation/swept_body.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace explore::simulation
{
namespace
{
constexpr double kFullTurn_rad = 2.0 * std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Triangle moved(const Eigen::Isometry3d& transform, const Triangle& triangle)
{
	return {transform * triangle[0], transform * triangle[1], transform * triangle[2]};
}

Triangle cornersOf(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle)
{
	return {mesh.vertices[triangle[0]].cast<double>(), mesh.vertices[triangle[1]].cast<double>(),
	        mesh.vertices[triangle[2]].cast<double>()};
}

/** All triangles of the world where they stand now. */
template <class Visit>
void forEachTriangle(const RayScene& scene, const Visit& visit)
{
	const World& world = scene.world();
	for (const auto& triangle : world.mesh.triangles) visit(cornersOf(world.mesh, triangle));
	const std::vector<Eigen::Isometry3d> map_from_body = scene.placement();
	for (std::size_t i = 0; i < world.moving.size(); ++i)
		for (const auto& triangle : world.moving[i].mesh.triangles)
			visit(moved(map_from_body[i], cornersOf(world.moving[i].mesh, triangle)));
}

bool allFinite(const Triangle& triangle)
{
	return std::all_of(triangle.begin(), triangle.end(),
	                   [](const Eigen::Vector3d& corner) { return corner.allFinite(); });
}

struct Interval
{
	double low = kInfinity, high = -kInfinity;
	void add(double value)
	{
		low = std::min(low, value);
		high = std::max(high, value);
	}
};

Interval heightsOf(const Triangle& triangle)
{
	Interval heights;
	for (const Eigen::Vector3d& corner : triangle) heights.add(corner.z());
	return heights;
}
}  // namespace

SweptBody::SweptBody(const RayScene& scene, VerticalCylinder body, double reach_m, double max_elevation_rad)
    : m_body(std::move(body)), m_reach_m(reach_m)
{
	collect(scene, max_elevation_rad);
	std::stable_sort(m_obstacles.begin(), m_obstacles.end(),
	                 [](const Obstacle& a, const Obstacle& b) { return a.nearest_m < b.nearest_m; });
	sortIntoSectors();
}

void SweptBody::collect(const RayScene& scene, double max_elevation_rad)
{
	const Eigen::Vector2d center = m_body.base.head<2>();
	const double rise = m_reach_m * std::sin(std::abs(max_elevation_rad));
	const double low_z = m_body.base.z() - rise, high_z = m_body.base.z() + m_body.height_m + rise;
	forEachTriangle(scene,
	                [&](const Triangle& triangle)
	                {
		                if (!allFinite(triangle)) return;
		                const Interval heights = heightsOf(triangle);
		                if (!(heights.low <= high_z && heights.high >= low_z)) return;
		                const double nearest = planDistance(center, low_z, high_z, triangle);
		                if (nearest <= m_reach_m + m_body.radius_m)
			                m_obstacles.push_back({triangle, nearest, heights.low, heights.high});
	                });
}

void SweptBody::sortIntoSectors()
{
	constexpr double kSector_rad = kFullTurn_rad / static_cast<double>(kSectors);
	for (std::uint32_t index = 0; index < m_obstacles.size(); ++index)
	{
		const Obstacle& obstacle = m_obstacles[index];
		// What is in line with the body seen from its axis; a body of its width reaches a little to both sides.
		const auto azimuth = [&](std::size_t corner) { return azimuthOf(obstacle.corners[corner] - m_body.base); };
		Interval azimuths;
		for (std::size_t i = 0; i < 3; ++i) azimuths.add(wrapToPi(azimuth(i) - azimuth(0)));
		const bool beside = obstacle.nearest_m > m_body.radius_m;
		const double widening = beside ? std::asin(m_body.radius_m / obstacle.nearest_m) + 1e-6 : kFullTurn_rad;
		const double span = azimuths.high - azimuths.low + 2.0 * widening;
		// A polygon around the axis, or cut by height, may be seen all around.
		const bool everywhere = span >= std::numbers::pi;
		const double start = everywhere ? 0.0 : azimuth(0) + azimuths.low - widening;
		const double end = everywhere ? kFullTurn_rad - 0.5 * kSector_rad : start + span;
		for (double first = std::floor(start / kSector_rad), i = first; i <= std::floor(end / kSector_rad); ++i)
			m_sectors[static_cast<std::size_t>(i + 2.0 * static_cast<double>(kSectors)) % kSectors].push_back(index);
	}
}

double SweptBody::freePath(double azimuth_rad, double elevation_rad) const
{
	const double level = std::cos(elevation_rad);
	const Direction direction{{std::cos(azimuth_rad), std::sin(azimuth_rad)}, std::tan(elevation_rad)};
	const double turn = azimuth_rad / kFullTurn_rad - std::floor(azimuth_rad / kFullTurn_rad);
	double free = m_reach_m * level;
	for (const std::uint32_t index : m_sectors[static_cast<std::size_t>(turn * kSectors) % kSectors])
	{
		const Obstacle& obstacle = m_obstacles[index];
		if (obstacle.nearest_m - m_body.radius_m >= free) break;
		free = contact(obstacle, direction, free);
	}
	return free / level;
}

/** The distance forward, below `limit`, at which the body touches the obstacle; else `limit`. */
double SweptBody::contact(const Obstacle& obstacle, const Direction& direction, double limit) const
{
	Interval forward, left;
	for (const Eigen::Vector3d& corner : obstacle.corners)
	{
		const Eigen::Vector2d offset = (corner - m_body.base).head<2>();
		forward.add(offset.dot(direction.forward));
		left.add(direction.forward.x() * offset.y() - direction.forward.y() * offset.x());
	}
	const double radius = m_body.radius_m;
	if (left.low > radius || left.high < -radius) return limit;
	double from = std::max(0.0, forward.low - radius), to = std::min(limit, forward.high + radius);
	// The obstacle must lie between the heights of the body's faces, which rise on the way.
	const double below = obstacle.low_z - (m_body.base.z() + m_body.height_m),
	             above = obstacle.high_z - m_body.base.z();
	if (direction.rise == 0.0 && (below > 0.0 || above < 0.0)) return limit;
	if (direction.rise != 0.0)
	{
		const double a = below / direction.rise, b = above / direction.rise;
		from = std::max(from, std::min(a, b));
		to = std::min(to, std::max(a, b));
	}
	return from <= to ? std::min(limit, firstNear(obstacle, direction, from, to)) : limit;
}

/** The first place from which the obstacle is within the radius; infinite when there is none up to `to`. The distance
 *  of two convex bodies, one of them moving straight on, is a convex function of the way: Newton's method comes from
 *  the left and never steps over its zero, but for the length of the difference quotient. */
double SweptBody::firstNear(const Obstacle& obstacle, const Direction& direction, double from, double to) const
{
	constexpr double kStep_m = 1e-6, kTolerance_m = 1e-5;
	constexpr int kSteps = 100;  // some ten are usual
	const auto excess = [&](double forward)
	{
		const double low_z = m_body.base.z() + forward * direction.rise;
		return planDistance(m_body.base.head<2>() + forward * direction.forward, low_z, low_z + m_body.height_m,
		                    obstacle.corners) -
		       m_body.radius_m;
	};
	double forward = from, distance = excess(forward);
	// Rounding may leave nothing of an obstacle that begins right here.
	if (!std::isfinite(distance)) distance = excess(forward += kStep_m);
	for (int i = 0; i < kSteps && forward <= to && std::isfinite(distance); ++i)
	{
		if (distance <= kTolerance_m) return forward;
		const double slope = (excess(forward + kStep_m) - distance) / kStep_m;
		if (!(slope < 0.0)) break;
		forward += distance / -slope;
		distance = excess(forward);
	}
	return kInfinity;
}
}  // namespace explore::simulation
