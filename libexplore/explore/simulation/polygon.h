// Splits a polygon on the floor plan into triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace explore::simulation
{
/** The corners of `outline`, counter-clockwise, without repeated and collinear ones. Empty where no area is left. */
std::vector<Eigen::Vector2d> tidyOutline(std::span<const Eigen::Vector2d> outline);

/** Whether `point` lies inside the simple polygon; either answer on its edges. */
bool contains(std::span<const Eigen::Vector2d> outline, const Eigen::Vector2d& point);

/** One outline that runs along `outer` and around every hole, over cuts that it walks twice. All as tidyOutline gives
 *  them; holes lie inside `outer`, apart from each other. */
std::vector<Eigen::Vector2d> withHoles(std::vector<Eigen::Vector2d> outer,
                                       std::vector<std::vector<Eigen::Vector2d>> holes);

/** Triangles (indices into `outline`, counter-clockwise) that fill the simple polygon; outline.size() − 2 of them.
 *  `outline` is as tidyOutline or withHoles gives it. A polygon that crosses itself is filled in some way. */
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Eigen::Vector2d> outline);
}  // namespace explore::simulation
