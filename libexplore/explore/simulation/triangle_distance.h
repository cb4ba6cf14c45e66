// Exact distances between a triangle and the simple bodies that a robot is made of.
#pragma once

#include <Eigen/Core>

#include <array>

namespace explore::simulation
{
using Triangle = std::array<Eigen::Vector3d, 3>;  ///< corners; may be degenerate

/** Distance [m] from `point` to the nearest point of the triangle. */
double distanceToTriangle(const Eigen::Vector3d& point, const Triangle& triangle);

/** Distance [m] between the segment from `a` to `b` and the triangle; 0 where they meet. */
double distanceToTriangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Triangle& triangle);

/** Distance [m] on the floor plan from `center` to the part of the triangle with low_z ≤ z ≤ high_z; infinite where
 *  there is none. */
double planDistance(const Eigen::Vector2d& center, double low_z, double high_z, const Triangle& triangle);

/** A solid cylinder around the vertical axis through `base`. */
struct VerticalCylinder
{
	Eigen::Vector3d base = Eigen::Vector3d::Zero();  ///< middle of its lower face
	double radius_m = 0, height_m = 0;
};

/** Whether the two share a point, their surfaces included. */
bool meets(const VerticalCylinder& cylinder, const Triangle& triangle);
}  // namespace explore::simulation
