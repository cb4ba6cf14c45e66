// Planes, angles and rigid transforms: the few helpers that every layer shares.
#pragma once

#include <mrpt/poses/CPose3D.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <numbers>

namespace explore
{
/** One degree [rad]: 30 * kDegree_rad. */
inline constexpr double kDegree_rad = std::numbers::pi / 180;

/** Plane a·x + b·y + c·z + d = 0 with unit normal (a, b, c), as mrpt::math::TPlane. */
struct Plane
{
	Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
	double d_m = 0.0;

	/** Signed distance [m] of `point`, positive on the normal's side (paper eq. 2 without the absolute value). */
	[[nodiscard]] double signedDistance(const Eigen::Vector3d& point) const { return normal.dot(point) + d_m; }
	[[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& point) const
	{
		return point - signedDistance(point) * normal;
	}
	[[nodiscard]] Plane flipped() const { return {-normal, -d_m}; }
};

/** Plane with `normal` (any length above 0) through `point`. */
Plane planeThrough(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

/** Angle [rad] in [0, π/2] between the directions of `a` and `b`, their signs ignored (paper §3.1, θ between planes).
 */
double angleBetweenAxes(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/** The same heading in (−π, π]. */
double wrapToPi(double angle_rad);

/** Azimuth [rad] of `v`, positive to the left. */
double azimuthOf(const Eigen::Vector3d& v);

/** b_from_a as an Eigen transform. Positive pitch looks down, as in mrpt::poses::CPose3D. */
Eigen::Isometry3d isometryOf(const mrpt::poses::CPose3D& b_from_a);
}  // namespace explore
