// The few shapes that 3D scenes are drawn with, as MRPT's objects.
#pragma once

#include <explore/core/point_cloud.h>
#include <explore/sinks/picture_style.h>
#include <mrpt/opengl/CSetOfObjects.h>

#include <Eigen/Core>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace explore::scene
{
using Stretch = std::pair<Eigen::Vector3d, Eigen::Vector3d>;

/** One after the other; of a single point nothing is drawn. */
mrpt::opengl::CRenderizable::Ptr polyline(std::span<const Eigen::Vector3d> points, const mrpt::img::TColor& color,
                                          double width_px);
mrpt::opengl::CRenderizable::Ptr stretches(std::span<const Stretch> stretches, const mrpt::img::TColor& color,
                                           double width_px);
/** Square bars from each point to the next: seen from afar too, as lines, which are drawn one pixel wide, are not. */
mrpt::opengl::CRenderizable::Ptr bars(std::span<const Eigen::Vector3d> points, const mrpt::img::TColor& color,
                                      double thickness_m);
/** `thickness_m` of the shaft. */
mrpt::opengl::CRenderizable::Ptr arrow(const Stretch& from_to, const mrpt::img::TColor& color, double thickness_m);
/** Faces the observer wherever they stand; its colour is a brighter one. */
mrpt::opengl::CRenderizable::Ptr label(const std::string& text, const Eigen::Vector3d& at,
                                       const mrpt::img::TColor& color);
/** Colours as of heights above z = 0. */
mrpt::opengl::CRenderizable::Ptr cloud(const PointCloud& points, double point_px);
/** A ring on the floor with a point in its middle. */
mrpt::opengl::CRenderizable::Ptr ring(const Eigen::Vector3d& at, double radius_m, const mrpt::img::TColor& color);

/** An opening: its edges, in it the sign of its verdict, above it its label; all in the verdict's colour. The frame is
 *  that of the mark's corners. */
mrpt::opengl::CSetOfObjects::Ptr opening(const DoorMark& mark, Verdict verdict);
}  // namespace explore::scene
