#include <explore/core/geometry.h>
#include <explore/perception/sight_lines.h>

#include <algorithm>

namespace explore
{
bool SightLines::sees(const Eigen::Vector3d& direction_in_robot) const
{
	const auto pixel = pixelOfPoint(intrinsics, camera_from_robot * direction_in_robot);
	if (!pixel) return false;
	const Eigen::Array2d last(intrinsics.width_px - 1.0, intrinsics.height_px - 1.0);
	return (pixel->array() >= 0.0).all() && (pixel->array() <= last).all();
}

SightLines sightLines(const DepthFrame& frame)
{
	constexpr int kColumns = 80;
	SightLines lines;
	if (frame.image.empty()) return lines;
	const CameraIntrinsics& camera = frame.image.intrinsics;
	const Eigen::Isometry3d robot_from_camera = isometryOf(frame.robot_from_camera);
	const int stride = std::max(1, camera.width_px / kColumns), first = stride / 2;
	lines.intrinsics = camera;
	lines.camera_from_robot = robot_from_camera.linear().transpose();
	lines.origin_in_robot = robot_from_camera.translation();
	lines.columns = static_cast<std::size_t>((camera.width_px - first + stride - 1) / stride);
	for (int v = first; v < camera.height_px; v += stride)
		for (int u = first; u < camera.width_px; u += stride)
		{
			lines.ray_in_robot.push_back((robot_from_camera.linear() * rayOfPixel(camera, u, v)).cast<float>());
			lines.depth_m.push_back(frame.image.at(u, v));
		}
	return lines;
}
}  // namespace explore
