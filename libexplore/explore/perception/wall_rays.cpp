#include <explore/perception/wall_rays.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace explore
{
namespace
{
/** The part of the segment a–b (camera frame) that lies in front of the camera; both ends at least `near_m` deep. */
bool clipToFront(Eigen::Vector3d& a, Eigen::Vector3d& b)
{
	constexpr double kNear_m = 0.05;
	if (a.x() < kNear_m && b.x() < kNear_m) return false;
	if (a.x() < kNear_m) a += (kNear_m - a.x()) / (b.x() - a.x()) * (b - a);
	if (b.x() < kNear_m) b += (kNear_m - b.x()) / (a.x() - b.x()) * (a - b);
	return true;
}
}  // namespace

WallRays::Affine WallRays::along(const Eigen::Vector3d& axis_in_camera, const CameraIntrinsics& camera)
{
	const double origin = axis_in_camera.dot(rayOfPixel(camera, 0.0, 0.0));
	const double next_u = axis_in_camera.dot(rayOfPixel(camera, 1.0, 0.0));
	const double next_v = axis_in_camera.dot(rayOfPixel(camera, 0.0, 1.0));
	return {static_cast<float>(origin), static_cast<float>(next_u - origin), static_cast<float>(next_v - origin)};
}

WallRays::WallRays(const LevelPose& pose, const CameraIntrinsics& camera, const UprightWall& wall)
    : m_camera(camera),
      m_level_from_camera(pose.level_from_camera),
      m_wall(wall),
      m_offset_m(static_cast<float>(wall.offset_m)),
      m_camera_height_m(static_cast<float>(pose.cameraHeight_m()))
{
	const Eigen::Matrix3d camera_from_level = m_level_from_camera.linear().transpose();
	const Eigen::Vector2d tangent = wall.tangent();
	m_normal = along(camera_from_level * Eigen::Vector3d(wall.normal.x(), wall.normal.y(), 0.0), camera);
	m_tangent = along(camera_from_level * Eigen::Vector3d(tangent.x(), tangent.y(), 0.0), camera);
	m_up = along(camera_from_level.col(2), camera);
}

PixelBox WallRays::boxOf(const WallRectangle& rectangle) const
{
	const auto corner = [&](double along_m, double height_m)
	{
		const Eigen::Vector2d foot = m_wall.at(along_m);
		return Eigen::Vector3d(m_level_from_camera.inverse() * Eigen::Vector3d(foot.x(), foot.y(), height_m));
	};
	const std::array<Eigen::Vector3d, 4> corners{
	    corner(rectangle.from_m, rectangle.bottom_m), corner(rectangle.from_m, rectangle.top_m),
	    corner(rectangle.to_m, rectangle.top_m), corner(rectangle.to_m, rectangle.bottom_m)};
	Eigen::Array2d low = Eigen::Array2d::Constant(1e9), high = -low;
	for (std::size_t i = 0; i < corners.size(); ++i)
	{
		Eigen::Vector3d a = corners.at(i), b = corners.at((i + 1) % corners.size());
		if (!clipToFront(a, b)) continue;
		for (const Eigen::Vector3d& point : {a, b})
		{
			const Eigen::Vector2d pixel = pixelOfPoint(m_camera, point).value();
			low = low.min(pixel.array());
			high = high.max(pixel.array());
		}
	}
	const auto clipped = [](double value, int last)
	{ return static_cast<int>(std::clamp(value, -1.0, static_cast<double>(last) + 1.0)); };
	const int last_u = m_camera.width_px - 1, last_v = m_camera.height_px - 1;
	return {std::max(0, clipped(std::floor(low.x()), last_u)), std::min(last_u, clipped(std::ceil(high.x()), last_u)),
	        std::max(0, clipped(std::floor(low.y()), last_v)), std::min(last_v, clipped(std::ceil(high.y()), last_v))};
}
}  // namespace explore
