#include <explore/core/geometry.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore
{
Plane planeThrough(const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
{
	const Eigen::Vector3d unit = normal.normalized();
	return {unit, -unit.dot(point)};
}

double angleBetweenAxes(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
	// atan2 keeps its precision near 0, where acos loses half the digits.
	return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

double wrapToPi(double angle_rad)
{
	const double wrapped = std::remainder(angle_rad, 2.0 * std::numbers::pi);
	return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

double azimuthOf(const Eigen::Vector3d& v)
{
	return wrapToPi(std::atan2(v.y(), v.x()));
}

Eigen::Isometry3d isometryOf(const mrpt::poses::CPose3D& b_from_a)
{
	Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
	const auto rotation = b_from_a.getRotationMatrix();
	for (int row = 0; row < 3; ++row)
		for (int col = 0; col < 3; ++col) result.linear()(row, col) = rotation(row, col);
	result.translation() << b_from_a.x(), b_from_a.y(), b_from_a.z();
	return result;
}
}  // namespace explore
