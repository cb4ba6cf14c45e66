// Where the camera looked and how far it saw: what the avoider takes for observed, and what not.
#pragma once

#include <explore/core/depth_frame.h>

namespace explore
{
/** A thinned grid of the image's rays, row by row from the top left; all arrays have the same length. */
struct SightLines
{
	CameraIntrinsics intrinsics;
	Eigen::Matrix3d camera_from_robot = Eigen::Matrix3d::Identity();  ///< rotation
	Eigen::Vector3d origin_in_robot = Eigen::Vector3d::Zero();
	std::size_t columns = 0;     ///< of the grid
	PointCloud ray_in_robot;     ///< per metre of depth
	std::vector<float> depth_m;  ///< 0 = no return

	[[nodiscard]] bool empty() const { return depth_m.empty(); }
	[[nodiscard]] std::size_t size() const { return depth_m.size(); }
	/** Whether a direction [robot frame, any length] lies within the image. */
	[[nodiscard]] bool sees(const Eigen::Vector3d& direction_in_robot) const;
};

/** About 80 × 60 rays of an image; none of an unorganised cloud, which does not tell where its sensor looked. */
SightLines sightLines(const DepthFrame& frame);
}  // namespace explore
