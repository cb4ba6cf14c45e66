#include <explore/core/depth_frame.h>

namespace explore
{
std::string nameOf(PoseOrigin origin)
{
	switch (origin)
	{
		case PoseOrigin::robot_pose:
			return "robot_pose";
		case PoseOrigin::odometry:
			return "odometry";
		case PoseOrigin::action:
			return "action";
		case PoseOrigin::robot_link:
			return "robot_link";
		case PoseOrigin::none:
			break;
	}
	return "none";
}

Eigen::Vector3d rayOfPixel(const CameraIntrinsics& intrinsics, double u_px, double v_px)
{
	return {1.0, (intrinsics.cx_px - u_px) / intrinsics.fx_px, (intrinsics.cy_px - v_px) / intrinsics.fy_px};
}

std::optional<Eigen::Vector2d> pixelOfPoint(const CameraIntrinsics& intrinsics, const Eigen::Vector3d& point_in_camera)
{
	if (point_in_camera.x() <= 0.0) return std::nullopt;
	return Eigen::Vector2d(intrinsics.cx_px - intrinsics.fx_px * point_in_camera.y() / point_in_camera.x(),
	                       intrinsics.cy_px - intrinsics.fy_px * point_in_camera.z() / point_in_camera.x());
}
}  // namespace explore
