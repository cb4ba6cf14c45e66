#include <explore/sinks/camera_projection.h>

#include <cmath>

namespace explore
{
namespace
{
constexpr double kNear_m = 0.15;  // lines are cut off here, in front of the camera
}  // namespace

CameraProjection::CameraProjection(const DepthFrame& frame)
    : m_frame(frame), m_camera_from_robot(isometryOf(frame.robot_from_camera).inverse())
{
}

std::optional<Eigen::Vector2d> CameraProjection::pixel(const Eigen::Vector3d& point_in_robot) const
{
	return pixelOfPoint(m_frame.image.intrinsics, inCamera(point_in_robot));
}

std::optional<ImageSegment> CameraProjection::segment(const Eigen::Vector3d& a_in_robot,
                                                      const Eigen::Vector3d& b_in_robot) const
{
	Eigen::Vector3d a = inCamera(a_in_robot), b = inCamera(b_in_robot);
	if (a.x() < kNear_m && b.x() < kNear_m) return std::nullopt;
	const Eigen::Vector3d cut = a + (b - a) * ((kNear_m - a.x()) / (b.x() - a.x()));
	if (a.x() < kNear_m) a = cut;
	if (b.x() < kNear_m) b = cut;
	const auto& intrinsics = m_frame.image.intrinsics;
	return ImageSegment(*pixelOfPoint(intrinsics, a), *pixelOfPoint(intrinsics, b));
}

bool CameraProjection::shows(const Eigen::Vector3d& point_in_robot) const
{
	const Eigen::Vector3d point = inCamera(point_in_robot);
	const auto& intrinsics = m_frame.image.intrinsics;
	const auto uv = pixelOfPoint(intrinsics, point);
	if (!uv || uv->x() < 0 || uv->y() < 0 || uv->x() > intrinsics.width_px - 1 || uv->y() > intrinsics.height_px - 1)
		return false;
	const double depth = m_frame.image.at(static_cast<int>(uv->x()), static_cast<int>(uv->y()));
	return std::abs(depth - point.x()) < 0.1 + 0.02 * point.x();
}

std::vector<std::pair<double, double>> CameraProjection::shownStretches(const Line& line_in_robot, double reach_m) const
{
	constexpr double kStep_m = 0.04;
	const auto steps = static_cast<int>(2.0 * reach_m / kStep_m);
	const auto along_m = [&](int step) { return step * kStep_m - reach_m; };
	std::vector<std::pair<double, double>> stretches;
	std::optional<int> begun;
	for (int step = 0; step <= steps + 1; ++step)
	{
		const bool shown = step <= steps && shows(line_in_robot.point + along_m(step) * line_in_robot.direction);
		if (shown && !begun) begun = step;
		if (shown || !begun) continue;
		if (step - 1 > *begun) stretches.emplace_back(along_m(*begun), along_m(step - 1));
		begun.reset();
	}
	return stretches;
}

std::vector<ImageSegment> CameraProjection::shownParts(const Line& line_in_robot, double reach_m) const
{
	const auto at = [&](double along_m) -> Eigen::Vector3d
	{ return line_in_robot.point + along_m * line_in_robot.direction; };
	std::vector<ImageSegment> parts;
	for (const auto& [from_m, to_m] : shownStretches(line_in_robot, reach_m))
		if (const auto ends = segment(at(from_m), at(to_m))) parts.push_back(*ends);
	return parts;
}
}  // namespace explore
