#include <explore/sinks/camera_projection.h>
#include <explore/sinks/camera_view.h>

#include <algorithm>

namespace explore
{
namespace
{
/** Robot-frame points to canvas pixels. */
class View
{
public:
	View(const DepthFrame& frame, const CanvasArea& area) : m_area(area), m_projection(frame)
	{
		const auto& intrinsics = frame.image.intrinsics;
		const double fit_x = double(area.right - area.left + 1) / intrinsics.width_px;
		const double fit_y = double(area.bottom - area.top + 1) / intrinsics.height_px;
		m_scale = std::min(fit_x, fit_y);
	}

	[[nodiscard]] double scale() const { return m_scale; }
	[[nodiscard]] const CameraProjection& projection() const { return m_projection; }
	[[nodiscard]] CanvasPoint onCanvas(const Eigen::Vector2d& image_px) const
	{
		return CanvasPoint(m_area.left, m_area.top) + m_scale * image_px;
	}
	[[nodiscard]] std::optional<CanvasPoint> pixel(const Eigen::Vector3d& point_in_robot) const
	{
		const auto uv = m_projection.pixel(point_in_robot);
		return uv ? std::optional(onCanvas(*uv)) : std::nullopt;
	}
	/** Both ends of the part of a segment that lies in front of the camera. */
	[[nodiscard]] std::optional<std::pair<CanvasPoint, CanvasPoint>> segment(const Eigen::Vector3d& a_in_robot,
	                                                                         const Eigen::Vector3d& b_in_robot) const
	{
		const auto ends = m_projection.segment(a_in_robot, b_in_robot);
		if (!ends) return std::nullopt;
		return std::pair(onCanvas(ends->first), onCanvas(ends->second));
	}

private:
	CanvasArea m_area;
	CameraProjection m_projection;
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
	for (const auto& [a, b] : view.projection().shownParts(line, 2.0 * max_range_m))
		canvas.line(view.onCanvas(a), view.onCanvas(b), 3.0, {style::kWall});
}

void drawDoor(Canvas& canvas, const View& view, const DoorMark& mark)
{
	const auto& corners = mark.corners_in_robot;
	for (std::size_t i = 0; i < corners.size(); ++i)
		if (const auto ends = view.segment(corners[i], corners[(i + 1) % corners.size()]))
			canvas.line(ends->first, ends->second, 3.0, {mark.color});
	const Eigen::Vector3d foot = 0.5 * (corners[0] + corners[1]), top = 0.5 * (corners[2] + corners[3]);
	const Eigen::Vector3d middle = foot + mark.label_height * (top - foot);
	if (const auto at = view.pixel(middle); at && canvas.clip().contains(*at))
		canvas.label(*at, mark.label, {mark.color, 0.9});
}

void drawVanishingPoint(Canvas& canvas, const View& view, const VanishingPoint& vanishing_point)
{
	const auto at = view.pixel(vanishing_point.point);
	if (!at || !canvas.clip().contains(*at)) return;
	canvas.ring(*at, 9.0, 3.0, {style::kVanishingPoint});
	canvas.disc(*at, 2.5, {style::kVanishingPoint});
	canvas.label(*at - CanvasPoint(0, 24), "VP", {style::kVanishingPoint, 0.9});
}

/** θ_a is left out: the picture's legend does not have it, and the chosen heading covers it. */
void drawHeadings(Canvas& canvas, const View& view, const StepResult& result)
{
	for (const HeadingArrow& arrow : headingArrows(result))
	{
		const auto ends = view.segment(arrow.from_in_robot, arrow.to_in_robot);
		if (!ends || arrow.kind == HeadingKind::avoid) continue;
		canvas.arrow(ends->first, ends->second, arrow.kind == HeadingKind::chosen ? 7.0 : 4.0,
		             {style::headingColor(arrow.kind)});
	}
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
