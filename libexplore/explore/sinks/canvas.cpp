#include <explore/sinks/canvas.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace explore
{
namespace
{
constexpr const char* kFont = "9x15B";
constexpr int kCharWidth_px = 9;
const mrpt::img::TColor kTextOnPlate(16, 18, 24);

double distanceToSegment(const CanvasPoint& p, const CanvasPoint& a, const CanvasPoint& b)
{
	const CanvasPoint along = b - a;
	const double length2 = along.squaredNorm();
	const double t = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
	return (p - (a + t * along)).norm();
}

/** Share of a pixel that an edge at this signed distance leaves inside; positive is inside. */
double edgeCoverage(double inside_px)
{
	return std::clamp(inside_px + 0.5, 0.0, 1.0);
}

std::uint8_t blend(std::uint8_t below, std::uint8_t above, double share)
{
	return static_cast<std::uint8_t>(std::lround(below + share * (above - below)));
}

double cross(const CanvasPoint& a, const CanvasPoint& b)
{
	return a.x() * b.y() - a.y() * b.x();
}
}  // namespace

Canvas::Canvas(int width_px, int height_px, const mrpt::img::TColor& background)
    : m_image(width_px, height_px, mrpt::img::CH_RGB), m_clip{0, 0, width_px - 1, height_px - 1}
{
	m_image.filledRectangle(0, 0, width_px - 1, height_px - 1, background);
	m_image.selectTextFont(kFont);
}

void Canvas::clipTo(const CanvasArea& area)
{
	m_clip = {std::max(area.left, 0), std::max(area.top, 0),
	          std::min(area.right, static_cast<int>(m_image.getWidth()) - 1),
	          std::min(area.bottom, static_cast<int>(m_image.getHeight()) - 1)};
}

void Canvas::pixel(int x, int y, const Ink& ink)
{
	if (x < m_clip.left || x > m_clip.right || y < m_clip.top || y > m_clip.bottom) return;
	auto* bgr = m_image.ptr<std::uint8_t>(static_cast<unsigned>(x), static_cast<unsigned>(y));
	bgr[0] = blend(bgr[0], ink.color.B, ink.opacity);
	bgr[1] = blend(bgr[1], ink.color.G, ink.opacity);
	bgr[2] = blend(bgr[2], ink.color.R, ink.opacity);
}

template <class Coverage>
void Canvas::shape(std::span<const CanvasPoint> corners, double margin_px, const Ink& ink, Coverage coverage)
{
	CanvasPoint low = corners.front(), high = corners.front();
	for (const CanvasPoint& corner : corners)
	{
		low = low.cwiseMin(corner);
		high = high.cwiseMax(corner);
	}
	if (!low.allFinite() || !high.allFinite()) return;
	// Clamped as doubles: a point almost beside the camera projects far outside of what an int holds.
	const auto column = [&](double x)
	{ return static_cast<int>(std::clamp(x, double(m_clip.left), double(m_clip.right))); };
	const auto row = [&](double y)
	{ return static_cast<int>(std::clamp(y, double(m_clip.top), double(m_clip.bottom))); };
	for (int y = row(low.y() - margin_px); y <= row(high.y() + margin_px); ++y)
		for (int x = column(low.x() - margin_px); x <= column(high.x() + margin_px); ++x)
			if (const double share = coverage(CanvasPoint(x, y)); share > 0.0)
				pixel(x, y, {ink.color, ink.opacity * share});
}

void Canvas::line(const CanvasPoint& a, const CanvasPoint& b, double width_px, const Ink& ink)
{
	const double half = 0.5 * width_px;
	shape(std::array{a, b}, half + 1.0, ink,
	      [&](const CanvasPoint& p) { return edgeCoverage(half - distanceToSegment(p, a, b)); });
}

void Canvas::dashedLine(const CanvasPoint& a, const CanvasPoint& b, double width_px, const Ink& ink)
{
	constexpr double kDash_px = 8.0, kMaxDashes = 1000.0;
	const double length = (b - a).norm();
	if (length < 1.0 || length > kMaxDashes * 2.0 * kDash_px) return;
	const CanvasPoint along = (b - a) / length;
	for (double at = 0.0; at < length; at += 2.0 * kDash_px)
		line(a + at * along, a + std::min(at + kDash_px, length) * along, width_px, ink);
}

void Canvas::arrow(const CanvasPoint& from, const CanvasPoint& to, double width_px, const Ink& ink)
{
	const double length = (to - from).norm();
	if (!(length > 1.0)) return;
	const CanvasPoint along = (to - from) / length, across(-along.y(), along.x());
	const double head = std::min(4.0 * width_px, 0.7 * length);
	const CanvasPoint neck = to - head * along;
	line(from, neck, width_px, ink);
	convexPolygon(std::array<CanvasPoint, 3>{to, neck + 0.5 * head * across, neck - 0.5 * head * across}, ink);
}

void Canvas::disc(const CanvasPoint& center, double radius_px, const Ink& ink)
{
	line(center, center, 2.0 * radius_px, ink);
}

void Canvas::ring(const CanvasPoint& center, double radius_px, double width_px, const Ink& ink)
{
	shape(std::array{center}, radius_px + width_px, ink,
	      [&](const CanvasPoint& p)
	      { return edgeCoverage(0.5 * width_px - std::abs((p - center).norm() - radius_px)); });
}

void Canvas::convexPolygon(std::span<const CanvasPoint> corners, const Ink& ink)
{
	double area = 0.0;
	for (std::size_t i = 0; i < corners.size(); ++i) area += cross(corners[i], corners[(i + 1) % corners.size()]);
	const double sense = area < 0.0 ? -1.0 : 1.0;
	shape(corners, 1.0, ink,
	      [&](const CanvasPoint& p)
	      {
		      double coverage = 1.0;
		      for (std::size_t i = 0; i < corners.size(); ++i)
		      {
			      const CanvasPoint edge = corners[(i + 1) % corners.size()] - corners[i];
			      if (edge.norm() < 1e-9) continue;
			      coverage = std::min(coverage, edgeCoverage(sense * cross(edge.normalized(), p - corners[i])));
		      }
		      return coverage;
	      });
}

int Canvas::textWidth(const std::string& text)
{
	return kCharWidth_px * static_cast<int>(text.size());
}

void Canvas::text(const CanvasPoint& at, const std::string& text, const mrpt::img::TColor& color)
{
	m_image.textOut(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())), text, color);
}

void Canvas::label(const CanvasPoint& at, const std::string& text, const Ink& ink)
{
	constexpr double kPad_px = 4.0;
	const double width = textWidth(text) + 2.0 * kPad_px, height = kTextHeight_px + 4.0;
	const double left =
	    std::clamp(at.x() - 0.5 * width, m_clip.left + 2.0, std::max(m_clip.right - width - 2.0, m_clip.left + 2.0));
	const double top =
	    std::clamp(at.y() - 0.5 * height, m_clip.top + 2.0, std::max(m_clip.bottom - height - 2.0, m_clip.top + 2.0));
	const CanvasPoint a(left, top), b(left + width, top + height);
	convexPolygon(std::array<CanvasPoint, 4>{a, CanvasPoint(b.x(), a.y()), b, CanvasPoint(a.x(), b.y())}, ink);
	this->text({left + kPad_px, top + 1.0}, text, kTextOnPlate);
}
}  // namespace explore
