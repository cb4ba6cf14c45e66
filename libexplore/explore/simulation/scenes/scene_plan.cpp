#include "scene_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace explore::simulation
{
namespace
{
/** Whether a line along an edge of `a` parts them. */
bool partedByEdgeOf(const Outline& a, const Outline& b)
{
	for (std::size_t i = 0; i < a.size(); ++i)
	{
		const Eigen::Vector2d edge = a[(i + 1) % a.size()] - a[i];
		const Eigen::Vector2d normal(-edge.y(), edge.x());
		const auto reach = [&normal](const Outline& outline)
		{
			Span span{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
			for (const Eigen::Vector2d& point : outline)
			{
				span.low = std::min(span.low, normal.dot(point));
				span.high = std::max(span.high, normal.dot(point));
			}
			return span;
		};
		if (!reach(a).overlaps(reach(b))) return true;
	}
	return false;
}

double distanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
	const Eigen::Vector2d edge = b - a;
	const double share = std::clamp((point - a).dot(edge) / std::max(edge.squaredNorm(), 1e-12), 0.0, 1.0);
	return (point - a - share * edge).norm();
}

double vertexDistance(const Outline& corners, const Outline& edges)
{
	double best = std::numeric_limits<double>::max();
	for (const Eigen::Vector2d& corner : corners)
		for (std::size_t i = 0; i < edges.size(); ++i)
			best = std::min(best, distanceToSegment(corner, edges[i], edges[(i + 1) % edges.size()]));
	return best;
}
}  // namespace

Eigen::Vector2d WallFrame::at(double along_m, double behind_m) const
{
	return origin + Eigen::Rotation2Dd(angle_rad) * Eigen::Vector2d(along_m, behind_m);
}

Eigen::Isometry3d WallFrame::pose(double along_m, double behind_m, double z_m, double turn_rad) const
{
	const Eigen::Vector2d place = at(along_m, behind_m);
	Eigen::Isometry3d result(Eigen::Translation3d(place.x(), place.y(), z_m));
	return result.rotate(Eigen::AngleAxisd(angle_rad + turn_rad, Eigen::Vector3d::UnitZ()));
}

Eigen::Vector2d WallFrame::coordinatesOf(const Eigen::Vector2d& point) const
{
	return Eigen::Rotation2Dd(-angle_rad) * (point - origin);
}

Outline rectangleOutline(const WallFrame& frame, const Span& along, const Span& behind)
{
	return {frame.at(along.low, behind.low), frame.at(along.high, behind.low), frame.at(along.high, behind.high),
	        frame.at(along.low, behind.high)};
}

Outline footprint(const Eigen::Isometry3d& building_from_thing, const Eigen::Vector2d& size_m)
{
	Outline outline;
	for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
		outline.emplace_back((building_from_thing * Eigen::Vector3d(x * size_m.x(), y * size_m.y(), 0)).head<2>());
	return outline;
}

Outline discOutline(const Eigen::Vector2d& center, double radius_m)
{
	constexpr int kCorners = 8;
	const double around_m = radius_m / std::cos(std::numbers::pi / kCorners);
	Outline outline;
	for (int i = 0; i < kCorners; ++i)
	{
		const double angle_rad = 2 * std::numbers::pi * i / kCorners;
		outline.emplace_back(center + around_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
	}
	return outline;
}

bool overlap(const Outline& a, const Outline& b)
{
	return !partedByEdgeOf(a, b) && !partedByEdgeOf(b, a);
}

double distanceBetween(const Outline& a, const Outline& b)
{
	return overlap(a, b) ? 0.0 : std::min(vertexDistance(a, b), vertexDistance(b, a));
}

bool FloorUse::isFree(const Outline& outline, double height_m) const
{
	const auto touches = [&outline](const Outline& taken) { return overlap(taken, outline); };
	const auto hides = [&](const Low& low) { return height_m >= low.height_m && overlap(low.outline, outline); };
	return std::none_of(m_taken.begin(), m_taken.end(), touches) && std::none_of(m_low.begin(), m_low.end(), hides);
}
}  // namespace explore::simulation
