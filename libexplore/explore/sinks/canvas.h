// A small drawing surface with smooth edges and transparency over MRPT's image class.
#pragma once

#include <mrpt/img/CImage.h>

#include <Eigen/Core>
#include <span>
#include <string>

namespace explore
{
/** Column and row on a canvas [px]; y grows downward, pixel centres at whole numbers. */
using CanvasPoint = Eigen::Vector2d;

struct Ink
{
	mrpt::img::TColor color;
	double opacity = 1.0;
};

/** Columns left … right and rows top … bottom, ends included. */
struct CanvasArea
{
	int left = 0, top = 0, right = 0, bottom = 0;
	[[nodiscard]] bool contains(const CanvasPoint& p) const
	{
		return p.x() >= left && p.x() <= right && p.y() >= top && p.y() <= bottom;
	}
};

class Canvas
{
public:
	Canvas(int width_px, int height_px, const mrpt::img::TColor& background);

	/** What follows is drawn inside `area` only. */
	void clipTo(const CanvasArea& area);
	[[nodiscard]] const CanvasArea& clip() const { return m_clip; }

	void pixel(int x, int y, const Ink& ink);
	void line(const CanvasPoint& a, const CanvasPoint& b, double width_px, const Ink& ink);
	void dashedLine(const CanvasPoint& a, const CanvasPoint& b, double width_px, const Ink& ink);
	/** Ends in a filled head; the tip is at `to`. */
	void arrow(const CanvasPoint& from, const CanvasPoint& to, double width_px, const Ink& ink);
	void disc(const CanvasPoint& center, double radius_px, const Ink& ink);
	void ring(const CanvasPoint& center, double radius_px, double width_px, const Ink& ink);
	/** Filled; corners in either sense of rotation. */
	void convexPolygon(std::span<const CanvasPoint> corners, const Ink& ink);
	/** Plain text with its left top corner at `at`; not clipped. */
	void text(const CanvasPoint& at, const std::string& text, const mrpt::img::TColor& color);
	/** Text on a plate of `ink`, centred at `at` but moved so that the clip area holds it. */
	void label(const CanvasPoint& at, const std::string& text, const Ink& ink);

	static int textWidth(const std::string& text);
	static constexpr int kTextHeight_px = 15;

	[[nodiscard]] const mrpt::img::CImage& image() const { return m_image; }

private:
	/** Blends `ink` with the coverage (0–1) that `coverage(point)` gives, over the box that holds `corners`. */
	template <class Coverage>
	void shape(std::span<const CanvasPoint> corners, double margin_px, const Ink& ink, Coverage coverage);

	mrpt::img::CImage m_image;
	CanvasArea m_clip;
};
}  // namespace explore
