#include <explore/sinks/scene/shapes.h>
#include <mrpt/opengl/CArrow.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CText.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace explore::scene
{
namespace
{
using Corners = std::vector<Eigen::Vector2d>;

mrpt::math::TPoint3D pointOf(const Eigen::Vector3d& point)
{
	return {point.x(), point.y(), point.z()};
}

mrpt::opengl::CSetOfLines::Ptr lines(const mrpt::img::TColor& color, double width_px)
{
	auto object = mrpt::opengl::CSetOfLines::Create();
	object->setColor_u8(color);
	object->setLineWidth(static_cast<float>(width_px));
	return object;
}

Corners arc(double from_rad, double to_rad)
{
	constexpr int kSteps = 16;
	Corners corners;
	for (int i = 0; i <= kSteps; ++i)
	{
		const double angle_rad = from_rad + (to_rad - from_rad) * i / kSteps;
		corners.emplace_back(std::cos(angle_rad), std::sin(angle_rad));
	}
	return corners;
}

/** Strokes within −1 to 1, right and up: the shapes that the report's doors have. */
std::vector<Corners> signOf(Verdict verdict)
{
	using std::numbers::pi;
	switch (verdict)
	{
		case Verdict::open:
			return {arc(0, 2 * pi)};
		case Verdict::ajar:
			return {{{-1, -1}, {1, -1}, {1, 1}, {-1, -1}}};
		case Verdict::passage:
			return {{{0, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 1}}};
		case Verdict::closed:
			return {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
		case Verdict::blocked:
			return {{{-1, -1}, {1, 1}}, {{-1, 1}, {1, -1}}};
		case Verdict::drop:
			return {{{-1, 0.7}, {1, 0.7}, {0, -1}, {-1, 0.7}}};
		case Verdict::partial:
			return {arc(pi / 2, 3 * pi / 2), {{0, 1}, {0, -1}}};
		case Verdict::unknown:
			break;
	}
	return {{{-1, 0}, {1, 0}}};
}

/** Half way to white: dark letters are hard to read on grey. */
mrpt::img::TColor brighter(const mrpt::img::TColor& color)
{
	const auto half = [](std::uint8_t value) { return static_cast<std::uint8_t>((value + 255) / 2); };
	return {half(color.R), half(color.G), half(color.B)};
}

/** The four sides of a bar; its ends stay open. */
void addBar(mrpt::opengl::CSetOfTriangles& triangles, const Stretch& from_to, const mrpt::img::TColor& color,
            double thickness_m)
{
	const Eigen::Vector3d along = from_to.second - from_to.first;
	if (along.norm() < 1e-6) return;
	const Eigen::Vector3d side = along.unitOrthogonal(), other = along.normalized().cross(side);
	std::array<Eigen::Vector3d, 4> edges{side + other, other - side, -side - other, side - other};
	for (Eigen::Vector3d& edge : edges) edge = from_to.first + 0.5 * thickness_m * edge;
	for (std::size_t i = 0; i < edges.size(); ++i)
	{
		const Eigen::Vector3d &a = edges[i], &b = edges[(i + 1) % edges.size()];
		for (const auto& corners : {std::array{a, b, Eigen::Vector3d(b + along)},
		                            std::array{a, Eigen::Vector3d(b + along), Eigen::Vector3d(a + along)}})
		{
			mrpt::opengl::TTriangle triangle;
			triangle.setColor(color);
			for (std::size_t k = 0; k < corners.size(); ++k)
			{
				triangle.vertices[k].xyzrgba.pt = pointOf(corners[k]);
				// As if it faced the light: colours tell verdicts apart, on the side in the shade too.
				triangle.vertices[k].normal = {0.0F, 0.0F, 1.0F};
			}
			triangles.insertTriangle(triangle);
		}
	}
}
}  // namespace

mrpt::opengl::CRenderizable::Ptr polyline(std::span<const Eigen::Vector3d> points, const mrpt::img::TColor& color,
                                          double width_px)
{
	auto object = lines(color, width_px);
	for (std::size_t i = 1; i < points.size(); ++i) object->appendLine(pointOf(points[i - 1]), pointOf(points[i]));
	return object;
}

mrpt::opengl::CRenderizable::Ptr stretches(std::span<const Stretch> stretches, const mrpt::img::TColor& color,
                                           double width_px)
{
	auto object = lines(color, width_px);
	for (const auto& [from, to] : stretches) object->appendLine(pointOf(from), pointOf(to));
	return object;
}

mrpt::opengl::CRenderizable::Ptr bars(std::span<const Eigen::Vector3d> points, const mrpt::img::TColor& color,
                                      double thickness_m)
{
	auto object = mrpt::opengl::CSetOfTriangles::Create();
	for (std::size_t i = 1; i < points.size(); ++i) addBar(*object, {points[i - 1], points[i]}, color, thickness_m);
	object->setColor_u8(color);
	return object;
}

mrpt::opengl::CRenderizable::Ptr arrow(const Stretch& from_to, const mrpt::img::TColor& color, double thickness_m)
{
	const double length_m = (from_to.second - from_to.first).norm();
	auto object = mrpt::opengl::CArrow::Create();
	object->setArrowEnds(pointOf(from_to.first), pointOf(from_to.second));
	object->setSmallRadius(static_cast<float>(0.5 * thickness_m));
	object->setLargeRadius(static_cast<float>(1.5 * thickness_m));
	object->setHeadRatio(static_cast<float>(std::min(0.5, 4.0 * thickness_m / std::max(length_m, 1e-3))));
	object->setColor_u8(color);
	return object;
}

mrpt::opengl::CRenderizable::Ptr label(const std::string& text, const Eigen::Vector3d& at,
                                       const mrpt::img::TColor& color)
{
	auto object = mrpt::opengl::CText::Create(text);
	object->setLocation(pointOf(at));
	object->setColor_u8(brighter(color));
	return object;
}

mrpt::opengl::CRenderizable::Ptr cloud(const PointCloud& points, double point_px)
{
	auto object = mrpt::opengl::CPointCloudColoured::Create();
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		const mrpt::img::TColorf color(style::heightColor(points.z[i]));
		object->push_back(points.x[i], points.y[i], points.z[i], color.R, color.G, color.B);
	}
	object->setPointSize(static_cast<float>(point_px));
	return object;
}

mrpt::opengl::CRenderizable::Ptr ring(const Eigen::Vector3d& at, double radius_m, const mrpt::img::TColor& color)
{
	std::vector<Eigen::Vector3d> points;
	for (const Eigen::Vector2d& corner : arc(0, 2 * std::numbers::pi))
		points.emplace_back(at + radius_m * Eigen::Vector3d(corner.x(), corner.y(), 0));
	points.push_back(at);
	return polyline(points, color, 4.0);
}

mrpt::opengl::CSetOfObjects::Ptr opening(const DoorMark& mark, Verdict verdict)
{
	constexpr double kBar_m = 0.04, kSign_m = 0.2, kLabelAbove_m = 0.2;
	const auto& [left, right, right_top, left_top] = mark.corners_in_robot;
	auto object = mrpt::opengl::CSetOfObjects::Create();
	const std::array<Eigen::Vector3d, 5> edges{left, right, right_top, left_top, left};
	object->insert(bars(edges, mark.color, kBar_m));
	const Eigen::Vector3d middle = 0.25 * (left + right + right_top + left_top);
	const Eigen::Vector3d along = (right - left).normalized(), up = (left_top - left).normalized();
	for (const Corners& stroke : signOf(verdict))
	{
		std::vector<Eigen::Vector3d> places;
		for (const Eigen::Vector2d& corner : stroke)
			places.emplace_back(middle + kSign_m * (corner.x() * along + corner.y() * up));
		object->insert(bars(places, mark.color, kBar_m));
	}
	object->insert(label(mark.label, 0.5 * (left_top + right_top) + kLabelAbove_m * up, mark.color));
	return object;
}
}  // namespace explore::scene
