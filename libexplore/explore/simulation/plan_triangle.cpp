#include <explore/simulation/plan_triangle.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace explore::simulation
{
namespace
{
double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
	return a.x() * b.y() - a.y() * b.x();
}
}  // namespace

PlanTriangle::PlanTriangle(const Triangle& triangle)
{
	for (std::size_t i = 0; i < 3; ++i)
	{
		const Eigen::Vector3d& from = triangle[i];
		const Eigen::Vector3d along = triangle[(i + 1) % 3] - from;
		m_edges[i] = {from.head<2>(), along.head<2>(), from.z(), along.z(), along.head<2>().squaredNorm()};
	}
	const Eigen::Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
	constexpr double kUpright = 1e-9;  // of the normal's length
	m_upright = !(std::abs(normal.z()) > kUpright * normal.norm());
	m_slope = m_upright ? Eigen::Vector2d::Zero() : Eigen::Vector2d(-normal.head<2>() / normal.z());
	m_steepest = m_slope.isZero(0.0) ? Eigen::Vector2d::Zero() : Eigen::Vector2d(m_slope.normalized());
}

std::optional<Heights> PlanTriangle::within(const Eigen::Vector2d& center, double radius_m) const
{
	Heights heights{HUGE_VAL, -HUGE_VAL};
	const auto add = [&heights](double z_m)
	{
		heights.low_m = std::min(heights.low_m, z_m);
		heights.high_m = std::max(heights.high_m, z_m);
	};
	for (const Edge& edge : m_edges) addEnds(edge, center, radius_m * radius_m, add);
	if (!m_upright)
		// Height is linear: where no edge bounds it, it is extreme at the circle's ends up and down the slope.
		for (const double side_m : {-radius_m, radius_m})
			if (const Eigen::Vector2d place = center + side_m * m_steepest; covers(place))
				add(m_edges[0].from_z + m_slope.dot(place - m_edges[0].from));
	if (heights.low_m > heights.high_m) return std::nullopt;
	return heights;
}

template <class Add>
void PlanTriangle::addEnds(const Edge& edge, const Eigen::Vector2d& center, double radius2, const Add& add)
{
	const Eigen::Vector2d to_start = edge.from - center;
	const double c = to_start.squaredNorm() - radius2;
	if (edge.length2 <= 0.0)
	{
		if (c <= 0.0) add(edge.from_z), add(edge.from_z + edge.along_z);
		return;
	}
	// |to_start + t · along|² = radius²
	const double b = to_start.dot(edge.along), discriminant = b * b - edge.length2 * c;
	if (discriminant < 0.0) return;
	const double root = std::sqrt(discriminant);
	const double first = std::max(0.0, (-b - root) / edge.length2), last = std::min(1.0, (-b + root) / edge.length2);
	if (first > last) return;
	add(edge.from_z + first * edge.along_z);
	add(edge.from_z + last * edge.along_z);
}

bool PlanTriangle::covers(const Eigen::Vector2d& place) const
{
	bool left = true, right = true;
	for (const Edge& edge : m_edges)
	{
		const double side = cross(edge.along, place - edge.from);
		left = left && side >= 0.0;
		right = right && side <= 0.0;
	}
	return left || right;
}

std::optional<double> surfaceBelow(const World& world, const Eigen::Vector3d& place_in_map)
{
	std::optional<double> highest_m;
	const auto look = [&](const Triangle& triangle)
	{
		const auto at = PlanTriangle(triangle).within(place_in_map.head<2>(), 0.0);
		if (at && at->high_m < place_in_map.z() && at->high_m > highest_m.value_or(-HUGE_VAL)) highest_m = at->high_m;
	};
	forEachTriangle(world, look);
	return highest_m;
}
}  // namespace explore::simulation
