#include <explore/sinks/camera_view.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kNear_m = 0.15;  // lines are cut off here, in front of the camera

/** Robot-frame points to canvas pixels. */
class View
{
public:
	View(const DepthFrame& frame, const CanvasArea& area)
	    : m_frame(frame), m_area(area), m_camera_from_robot(isometryOf(frame.robot_from_camera).inverse())
	{
		const auto& intrinsics = frame.image.intrinsics;
		const double fit_x = double(area.right - area.left + 1) / intrinsics.width_px;
		const double fit_y = double(area.bottom - area.top + 1) / intrinsics.height_px;
		m_scale = std::min(fit_x, fit_y);
	}

	[[nodiscard]] double scale() const { return m_scale; }
	[[nodiscard]] Eigen::Vector3d inCamera(const Eigen::Vector3d& point) const { return m_camera_from_robot * point; }
	[[nodiscard]] std::optional<CanvasPoint> pixel(const Eigen::Vector3d& point_in_camera) const
	{
		const auto uv = pixelOfPoint(m_frame.image.intrinsics, point_in_camera);
		if (!uv) return std::nullopt;
		return CanvasPoint(m_area.left + m_scale * uv->x(), m_area.top + m_scale * uv->y());
	}
	/** Both ends of the part of a segment that lies in front of the camera. */
	[[nodiscard]] std::optional<std::pair<CanvasPoint, CanvasPoint>> segment(const Eigen::Vector3d& a_in_robot,
	                                                                         const Eigen::Vector3d& b_in_robot) const
	{
		Eigen::Vector3d a = inCamera(a_in_robot), b = inCamera(b_in_robot);
		if (a.x() < kNear_m && b.x() < kNear_m) return std::nullopt;
		const Eigen::Vector3d cut = a + (b - a) * ((kNear_m - a.x()) / (b.x() - a.x()));
		if (a.x() < kNear_m) a = cut;
		if (b.x() < kNear_m) b = cut;
		return std::pair(*pixel(a), *pixel(b));
	}
	/** True where the depth image measures this very point. */
	[[nodiscard]] bool shows(const Eigen::Vector3d& point_in_robot) const
	{
		const Eigen::Vector3d point = inCamera(point_in_robot);
		const auto uv = pixelOfPoint(m_frame.image.intrinsics, point);
		const auto& intrinsics = m_frame.image.intrinsics;
		if (!uv || uv->x() < 0 || uv->y() < 0 || uv->x() > intrinsics.width_px - 1 ||
		    uv->y() > intrinsics.height_px - 1)
			return false;
		const double depth = m_frame.image.at(static_cast<int>(uv->x()), static_cast<int>(uv->y()));
		return std::abs(depth - point.x()) < 0.1 + 0.02 * point.x();
	}

private:
	const DepthFrame& m_frame;
	CanvasArea m_area;
	Eigen::Isometry3d m_camera_from_robot;
	double m_scale = 1.0;
};

void drawDepth(Canvas& canvas, const CanvasArea& area, const DepthImage& image, double scale, double max_range_m)
{
	const int width = static_cast<int>(scale * image.intrinsics.width_px);
	const int height = static_cast<int>(scale * image.intrinsics.height_px);
	for (int y = 0; y < height; ++y)
		for (int x = 0; x < width; ++x)
		{
			const float depth = image.at(std::min(static_cast<int>(x / scale), image.intrinsics.width_px - 1),
			                             std::min(static_cast<int>(y / scale), image.intrinsics.height_px - 1));
			if (depth > 0.0F) canvas.pixel(area.left + x, area.top + y, {style::depthColor(depth / max_range_m)});
		}
}

/** The parts of a wall–floor line that the camera sees. */
void drawFloorLine(Canvas& canvas, const View& view, const Line& line, double max_range_m)
{
	constexpr double kStep_m = 0.04;
	const double reach_m = 2.0 * max_range_m;
	for (double t = -reach_m; t < reach_m; t += kStep_m)
	{
		const Eigen::Vector3d a = line.point + t * line.direction, b = a + kStep_m * line.direction;
		if (!view.shows(a) || !view.shows(b)) continue;
		if (const auto ends = view.segment(a, b)) canvas.line(ends->first, ends->second, 3.0, {style::kWall});
	}
}

void drawDoor(Canvas& canvas, const View& view, const DoorMark& mark)
{
	const auto& corners = mark.corners_in_robot;
	for (std::size_t i = 0; i < corners.size(); ++i)
		if (const auto ends = view.segment(corners[i], corners[(i + 1) % corners.size()]))
			canvas.line(ends->first, ends->second, 3.0, {mark.color});
	const Eigen::Vector3d foot = 0.5 * (corners[0] + corners[1]), top = 0.5 * (corners[2] + corners[3]);
	const Eigen::Vector3d middle = foot + mark.label_height * (top - foot);
	if (const auto at = view.pixel(view.inCamera(middle)); at && canvas.clip().contains(*at))
		canvas.label(*at, mark.label, {mark.color, 0.9});
}

void drawVanishingPoint(Canvas& canvas, const View& view, const VanishingPoint& vanishing_point)
{
	const auto at = view.pixel(view.inCamera(vanishing_point.point));
	if (!at || !canvas.clip().contains(*at)) return;
	canvas.ring(*at, 9.0, 3.0, {style::kVanishingPoint});
	canvas.disc(*at, 2.5, {style::kVanishingPoint});
	canvas.label(*at - CanvasPoint(0, 24), "VP", {style::kVanishingPoint, 0.9});
}

void drawHeading(Canvas& canvas, const View& view, const std::optional<Ground>& ground, double heading_rad,
                 double reach_m, double width_px, const mrpt::img::TColor& color)
{
	constexpr double kStart_m = 0.6;
	const auto ends = view.segment(floorPoint(ground, heading_rad, kStart_m),
	                               floorPoint(ground, heading_rad, std::max(reach_m, kStart_m + 0.5)));
	if (ends) canvas.arrow(ends->first, ends->second, width_px, {color});
}

void drawHeadings(Canvas& canvas, const View& view, const StepResult& result)
{
	const Headings& headings = result.decision.headings;
	const auto& ground = result.percepts.ground;
	if (headings.vanishing_point_rad)
		drawHeading(canvas, view, ground, *headings.vanishing_point_rad, 3.0, 4.0, style::kVanishingPoint);
	if (headings.door_rad) drawHeading(canvas, view, ground, *headings.door_rad, 2.5, 4.0, style::kDoorHeading);
	if (headings.chosen_rad) drawHeading(canvas, view, ground, *headings.chosen_rad, 1.9, 7.0, style::kChosen);
}
}  // namespace

void drawCameraView(Canvas& canvas, const CanvasArea& area, const DepthFrame& frame, const StepResult& result,
                    const PictureConfig& config, const PictureNotes& notes)
{
	canvas.clipTo(area);
	if (frame.image.empty())
	{
		canvas.text({area.left + 16.0, area.top + 16.0}, "a cloud of points: no image", style::kFaint);
		return;
	}
	const View view(frame, area);
	drawDepth(canvas, area, frame.image, view.scale(), config.max_range_m);
	for (const Wall& wall : result.percepts.walls) drawFloorLine(canvas, view, wall.floor_line, config.max_range_m);
	drawHeadings(canvas, view, result);
	for (const DoorMark& mark : notes.doors) drawDoor(canvas, view, mark);
	for (const Door& door : result.percepts.doors) drawDoor(canvas, view, markOf(door, result.percepts.ground));
	for (const auto& vanishing_point : result.percepts.vanishing_points)
		drawVanishingPoint(canvas, view, vanishing_point);
}
}  // namespace explore
