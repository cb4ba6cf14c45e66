#include <explore/sinks/canvas.h>
#include <gtest/gtest.h>

#include <array>
#include <numbers>

using namespace explore;

namespace
{
const mrpt::img::TColor kBlack(0, 0, 0), kWhite(255, 255, 255);

/** Sum of all brightness, in white pixels. */
double inkOf(const Canvas& canvas)
{
	double sum = 0;
	const auto& image = canvas.image();
	for (unsigned y = 0; y < image.getHeight(); ++y)
		for (unsigned x = 0; x < image.getWidth(); ++x) sum += image.at<std::uint8_t>(x, y, 0) / 255.0;
	return sum;
}

int brightness(const Canvas& canvas, unsigned x, unsigned y)
{
	return canvas.image().at<std::uint8_t>(x, y, 0);
}
}  // namespace

TEST(Canvas, ShapesCoverTheirArea)
{
	Canvas line(200, 200, kBlack), disc(200, 200, kBlack), ring(200, 200, kBlack), triangle(200, 200, kBlack);
	line.line({20.0, 30.0}, {140.0, 110.0}, 4.0, {kWhite});  // a bar of 144.2 × 4 with round ends
	EXPECT_NEAR(inkOf(line), 144.22 * 4.0 + std::numbers::pi * 4.0, 6.0);
	disc.disc({100.3, 90.7}, 30.0, {kWhite});
	EXPECT_NEAR(inkOf(disc), std::numbers::pi * 900.0, 15.0);
	ring.ring({100.0, 100.0}, 50.0, 3.0, {kWhite});
	EXPECT_NEAR(inkOf(ring), 2.0 * std::numbers::pi * 50.0 * 3.0, 10.0);
	triangle.convexPolygon(std::array<CanvasPoint, 3>{CanvasPoint(20, 20), CanvasPoint(20, 120), CanvasPoint(120, 20)},
	                       {kWhite});
	EXPECT_NEAR(inkOf(triangle), 5000.0, 60.0);
}

TEST(Canvas, PolygonDoesNotCareForItsSense)
{
	Canvas one(100, 100, kBlack), other(100, 100, kBlack);
	const CanvasPoint a(10, 10), b(80, 20), c(40, 90);
	one.convexPolygon(std::array{a, b, c}, {kWhite});
	other.convexPolygon(std::array{c, b, a}, {kWhite});
	EXPECT_GT(inkOf(one), 1000.0);
	EXPECT_NEAR(inkOf(one), inkOf(other), 1.0);  // rounding at the edges
}

TEST(Canvas, NothingIsDrawnOutsideTheClipArea)
{
	Canvas canvas(100, 100, kBlack);
	canvas.clipTo({20, 30, 59, 69});
	canvas.convexPolygon(std::array<CanvasPoint, 4>{CanvasPoint(-1e9, -1e9), CanvasPoint(1e9, -1e9),
	                                                CanvasPoint(1e9, 1e9), CanvasPoint(-1e9, 1e9)},
	                     {kWhite});
	EXPECT_NEAR(inkOf(canvas), 40.0 * 40.0, 1e-9);
	EXPECT_EQ(brightness(canvas, 19, 50), 0);
	EXPECT_EQ(brightness(canvas, 20, 50), 255);
}

TEST(Canvas, OpacityBlends)
{
	Canvas canvas(10, 10, kBlack);
	canvas.pixel(3, 4, {kWhite, 0.5});
	EXPECT_NEAR(brightness(canvas, 3, 4), 128, 1);
}

TEST(Canvas, PointsWithoutValueDrawNothing)
{
	Canvas canvas(50, 50, kBlack);
	const CanvasPoint nowhere(std::nan(""), 10.0);
	canvas.line(nowhere, {20, 20}, 3.0, {kWhite});
	canvas.arrow(nowhere, {20, 20}, 3.0, {kWhite});
	canvas.disc(nowhere, 3.0, {kWhite});
	EXPECT_EQ(inkOf(canvas), 0.0);
}

TEST(Canvas, ArrowPointsAtItsTarget)
{
	Canvas canvas(100, 100, kBlack);
	canvas.arrow({10, 50}, {90, 50}, 4.0, {kWhite});
	EXPECT_EQ(brightness(canvas, 30, 50), 255);
	EXPECT_EQ(brightness(canvas, 30, 56), 0);
	EXPECT_EQ(brightness(canvas, 76, 54), 255);  // the head is wider than the shaft
	EXPECT_EQ(brightness(canvas, 94, 50), 0);
}

TEST(Canvas, LabelStaysInsideTheClipArea)
{
	Canvas canvas(200, 100, kBlack);
	canvas.clipTo({100, 0, 199, 99});
	canvas.label({90.0, -30.0}, "door", {kWhite});
	double left_of_clip = 0, inside = 0;
	for (unsigned y = 0; y < 100; ++y)
	{
		for (unsigned x = 0; x < 100; ++x) left_of_clip += brightness(canvas, x, y);
		for (unsigned x = 100; x < 200; ++x) inside += brightness(canvas, x, y);
	}
	EXPECT_EQ(left_of_clip, 0.0);
	EXPECT_GT(inside / 255.0, 400.0);
}
