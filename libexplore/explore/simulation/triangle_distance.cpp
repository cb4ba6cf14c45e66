#include <explore/simulation/triangle_distance.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace explore::simulation
{
namespace
{
template <class Vector>
double squaredDistanceToSegment(const Vector& point, const Vector& a, const Vector& b)
{
	const Vector along = b - a;
	const double squared_length = along.squaredNorm();
	const double s = squared_length > 0.0 ? std::clamp((point - a).dot(along) / squared_length, 0.0, 1.0) : 0.0;
	return (a + s * along - point).squaredNorm();
}

/** Whether `point`, which lies in the plane of the triangle, is on the inner side of its three edges. */
bool insideEdges(const Eigen::Vector3d& point, const Triangle& triangle, const Eigen::Vector3d& normal)
{
	for (std::size_t i = 0; i < 3; ++i)
	{
		const Eigen::Vector3d& a = triangle[i];
		if ((triangle[(i + 1) % 3] - a).cross(point - a).dot(normal) < 0.0) return false;
	}
	return true;
}

double squaredDistanceOfSegments(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                 const Eigen::Vector3d& d)
{
	const Eigen::Vector3d first = b - a, second = d - c, between = a - c;
	const double ff = first.squaredNorm(), ss = second.squaredNorm(), fs = first.dot(second);
	const double determinant = ff * ss - fs * fs;
	double nearest = std::min(std::min(squaredDistanceToSegment(a, c, d), squaredDistanceToSegment(b, c, d)),
	                          std::min(squaredDistanceToSegment(c, a, b), squaredDistanceToSegment(d, a, b)));
	if (determinant > 0.0)
	{
		const double s = (fs * second.dot(between) - ss * first.dot(between)) / determinant;
		const double t = (ff * second.dot(between) - fs * first.dot(between)) / determinant;
		if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0)
			nearest = std::min(nearest, (between + s * first - t * second).squaredNorm());
	}
	return nearest;
}

/** A convex polygon of few corners. */
struct Polygon
{
	std::array<Eigen::Vector3d, 8> corners;
	std::size_t size = 0;
	void add(const Eigen::Vector3d& corner) { corners[size++] = corner; }
};

/** The part of `polygon` where sign · z ≤ sign · limit. */
Polygon clippedInHeight(const Polygon& polygon, double sign, double limit)
{
	Polygon kept;
	for (std::size_t i = 0; i < polygon.size; ++i)
	{
		const Eigen::Vector3d &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.size];
		const double excess_a = sign * (a.z() - limit), excess_b = sign * (b.z() - limit);
		if (excess_a <= 0.0) kept.add(a);
		if ((excess_a < 0.0 && excess_b > 0.0) || (excess_a > 0.0 && excess_b < 0.0))
			kept.add(a + (b - a) * (excess_a / (excess_a - excess_b)));
	}
	return kept;
}

/** Squared distance from `center` to the polygon as seen from above. */
double squaredPlanDistance(const Eigen::Vector2d& center, const Polygon& polygon)
{
	double nearest = std::numeric_limits<double>::infinity();
	bool left = true, right = true;
	for (std::size_t i = 0; i < polygon.size; ++i)
	{
		const Eigen::Vector2d a = polygon.corners[i].head<2>();
		const Eigen::Vector2d b = polygon.corners[(i + 1) % polygon.size].head<2>();
		const Eigen::Vector2d along = b - a, to_center = center - a;
		const double side = along.x() * to_center.y() - along.y() * to_center.x();
		left = left && side > 0.0;
		right = right && side < 0.0;
		nearest = std::min(nearest, squaredDistanceToSegment(center, a, b));
	}
	return polygon.size >= 3 && (left || right) ? 0.0 : nearest;
}
}  // namespace

double distanceToTriangle(const Eigen::Vector3d& point, const Triangle& triangle)
{
	const Eigen::Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
	const double length = normal.norm();
	if (length > 0.0)
	{
		const double height = (point - triangle[0]).dot(normal) / length;
		if (insideEdges(point - normal * (height / length), triangle, normal)) return std::abs(height);
	}
	double nearest = std::numeric_limits<double>::infinity();
	for (std::size_t i = 0; i < 3; ++i)
		nearest = std::min(nearest, squaredDistanceToSegment(point, triangle[i], triangle[(i + 1) % 3]));
	return std::sqrt(nearest);
}

double distanceToTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Triangle& triangle)
{
	const Eigen::Vector3d normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
	const double height_a = (a - triangle[0]).dot(normal), height_b = (b - triangle[0]).dot(normal);
	if ((height_a < 0.0) != (height_b < 0.0) &&
	    insideEdges(a + (b - a) * (height_a / (height_a - height_b)), triangle, normal))
		return 0.0;
	double nearest = std::min(distanceToTriangle(a, triangle), distanceToTriangle(b, triangle));
	for (std::size_t i = 0; i < 3; ++i)
		nearest = std::min(nearest, std::sqrt(squaredDistanceOfSegments(a, b, triangle[i], triangle[(i + 1) % 3])));
	return nearest;
}

double planDistance(const Eigen::Vector2d& center, double low_z, double high_z, const Triangle& triangle)
{
	Polygon polygon;
	for (const Eigen::Vector3d& corner : triangle) polygon.add(corner);
	polygon = clippedInHeight(polygon, 1.0, high_z);
	polygon = clippedInHeight(polygon, -1.0, low_z);
	return polygon.size > 0 ? std::sqrt(squaredPlanDistance(center, polygon)) : std::numeric_limits<double>::infinity();
}

bool meets(const VerticalCylinder& cylinder, const Triangle& triangle)
{
	const double low_z = cylinder.base.z();
	return planDistance(cylinder.base.head<2>(), low_z, low_z + cylinder.height_m, triangle) <= cylinder.radius_m;
}
}  // namespace explore::simulation
