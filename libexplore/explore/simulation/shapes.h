// Triangle meshes of the simple shapes that worlds are made of; normals point outward (counter-clockwise triangles).
#pragma once

#include <explore/simulation/world.h>

#include <span>

namespace explore::simulation
{
/** Centred on the origin. */
TriangleMesh boxMesh(const Eigen::Vector3d& size_m);
/** Around z, centred on the origin, closed. */
TriangleMesh cylinderMesh(double radius_m, double length_m, int sides = 24);
TriangleMesh sphereMesh(double radius_m, int rings = 12);
/** Cylinder of `length_m` between two half spheres, around z, centred on the origin. */
TriangleMesh capsuleMesh(double radius_m, double length_m, int sides = 16);
/** A rectangle in the plane through the origin with `normal` (any length), seen from both sides. */
TriangleMesh planeMesh(const Eigen::Vector3d& normal, const Eigen::Vector2d& size_m);
/** The simple polygon `outline` (either sense of rotation), from z = 0 to `height_m`, closed at both ends. Empty where
 *  fewer than three different points are given. */
TriangleMesh prismMesh(std::span<const Eigen::Vector2d> outline, double height_m);
/** As prismMesh() for what an odd number of the `rings` surrounds; rings do not cross. */
TriangleMesh prismMesh(std::span<const std::vector<Eigen::Vector2d>> rings, double height_m);
/** A standing person 2·`radius_m` wide: legs, trunk and head; origin on the floor, x forward. */
TriangleMesh personMesh(double height_m = 1.75, double radius_m = 0.25);
}  // namespace explore::simulation
