// Where things in front of the robot are in its depth image, for everything that draws over it.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/results.h>

#include <optional>
#include <utility>
#include <vector>

namespace explore
{
/** A stretch in the image: column and row of both ends [px], perhaps beyond its edges. */
using ImageSegment = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

/** Points in the robot frame as pixels of a frame's depth image. */
class CameraProjection
{
public:
	/** The frame has an image and outlives this. */
	explicit CameraProjection(const DepthFrame& frame);

	/** Column and row [px], perhaps beyond the edges; no value behind the camera. */
	[[nodiscard]] std::optional<Eigen::Vector2d> pixel(const Eigen::Vector3d& point_in_robot) const;
	/** The part that lies in front of the camera; no value where none does. */
	[[nodiscard]] std::optional<ImageSegment> segment(const Eigen::Vector3d& a_in_robot,
	                                                  const Eigen::Vector3d& b_in_robot) const;
	/** True where the depth image measures this very point. */
	[[nodiscard]] bool shows(const Eigen::Vector3d& point_in_robot) const;
	/** The stretches of a line that the image shows, up to `reach_m` either way from its point: where they begin and
	 * end along its direction [m], one after the other. */
	[[nodiscard]] std::vector<std::pair<double, double>> shownStretches(const Line& line_in_robot,
	                                                                    double reach_m) const;
	/** The same in the image. */
	[[nodiscard]] std::vector<ImageSegment> shownParts(const Line& line_in_robot, double reach_m) const;

private:
	[[nodiscard]] Eigen::Vector3d inCamera(const Eigen::Vector3d& point) const { return m_camera_from_robot * point; }

	const DepthFrame& m_frame;
	Eigen::Isometry3d m_camera_from_robot;
};
}  // namespace explore
