#include "scene_view.h"

#include <explore/core/geometry.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace explore::simulation
{
namespace
{
constexpr int kDraws = 400;
constexpr double kFarthestEdge_m = 4.97, kWallClearance_m = 0.08;

/** Bearings of the subject's edges from `camera`, relative to that of its middle. */
struct Bearings
{
	double middle_rad = 0, lowest_rad = 0, highest_rad = 0;
};

Bearings bearingsOf(const Subject& subject, const Eigen::Vector2d& camera)
{
	const auto bearing = [&camera](const Eigen::Vector2d& point)
	{ return std::atan2(point.y() - camera.y(), point.x() - camera.x()); };
	Bearings bearings{bearing(subject.middle())};
	const double a_rad = wrapToPi(bearing(subject.low()) - bearings.middle_rad);
	const double b_rad = wrapToPi(bearing(subject.high()) - bearings.middle_rad);
	bearings.lowest_rad = std::min(a_rad, b_rad), bearings.highest_rad = std::max(a_rad, b_rad);
	return bearings;
}

/** A roll turns the image's corners in. */
double usableHalfView(const Sketch& sketch)
{
	return sketch.halfView_rad() - (sketch.flies() ? 3.0 : 1.0) * kDegree_rad;
}

Eigen::Vector2d drawCamera(Sketch& sketch, const Subject& subject, const ViewRange& range)
{
	const double distance_m = sketch.draw(range.distance_m), offset_rad = sketch.drawAngle(range.offset_deg);
	const double side = range.side != 0 ? range.side : sketch.random.sign();
	return subject.frame.at(subject.along.middle() + side * distance_m * std::sin(offset_rad),
	                        -distance_m * std::cos(offset_rad));
}

bool standsFree(const Sketch& sketch, const Subject& subject, const Eigen::Vector2d& camera)
{
	const double farthest_m = std::max((subject.low() - camera).norm(), (subject.high() - camera).norm());
	const double before_m = -subject.frame.coordinatesOf(camera).y() - sketch.view.mount_forward_m;
	return farthest_m <= kFarthestEdge_m && before_m >= sketch.robot.radius_m + kWallClearance_m;
}

/** The yaw at which the camera sees both edges. */
std::optional<double> yawOnto(Sketch& sketch, const Subject& subject, const Eigen::Vector2d& camera)
{
	const Bearings bearings = bearingsOf(subject, camera);
	const Span yaw{bearings.highest_rad - usableHalfView(sketch), bearings.lowest_rad + usableHalfView(sketch)};
	if (yaw.length() < 0) return std::nullopt;
	return bearings.middle_rad + sketch.draw(yaw);
}

/** The yaw at which the camera sees one edge, and the other is out of the image. */
std::optional<double> yawPast(Sketch& sketch, const Subject& subject, const Eigen::Vector2d& camera)
{
	const Bearings bearings = bearingsOf(subject, camera);
	const double width_rad = bearings.highest_rad - bearings.lowest_rad, half_rad = sketch.halfView_rad();
	if (width_rad < 8 * kDegree_rad) return std::nullopt;
	const double cut_rad = sketch.random.uniform(0.25, 0.6) * width_rad;
	return bearings.middle_rad + (sketch.random.chance(0.5) ? bearings.highest_rad - cut_rad - half_rad
	                                                        : bearings.lowest_rad + cut_rad + half_rad);
}

/** The lane from the robot to the subject stays free, so that it can be approached. */
void keepLane(Sketch& sketch, const Subject& subject)
{
	constexpr double kEnd_m = 0.5, kBeside_m = 0.1;
	const Eigen::Vector2d from = sketch.robotPosition(), to = subject.middle() + kEnd_m * subject.frame.outward();
	const Eigen::Vector2d way = to - from;
	if (way.norm() < 0.1) return;
	const WallFrame lane{from, std::atan2(way.y(), way.x())};
	sketch.floor_use.take(rectangleOutline(lane, {0, way.norm()}, around(0, 2 * (sketch.robot.radius_m + kBeside_m))));
}

template <class Aim>
bool look(Sketch& sketch, const Subject& subject, const ViewRange& range, const Aim& aim)
{
	for (int i = 0; i < kDraws; ++i)
	{
		const Eigen::Vector2d camera = drawCamera(sketch, subject, range);
		if (!standsFree(sketch, subject, camera)) continue;
		const std::optional<double> yaw_rad = aim(sketch, subject, camera);
		if (!yaw_rad) continue;
		sketch.view.camera = camera, sketch.view.yaw_rad = *yaw_rad;
		standAt(sketch, sketch.robotPosition(), *yaw_rad);
		keepInSight(sketch, subject);
		keepLane(sketch, subject);
		return true;
	}
	sketch.possible = false;
	return false;
}
}  // namespace

bool lookAt(Sketch& sketch, const Subject& subject, const ViewRange& range)
{
	return look(sketch, subject, range, yawOnto);
}

bool lookPast(Sketch& sketch, const Subject& subject, const ViewRange& range)
{
	return look(sketch, subject, range, yawPast);
}

void standAt(Sketch& sketch, const Eigen::Vector2d& place, double yaw_rad)
{
	constexpr double kAround_m = 0.25;
	sketch.view.yaw_rad = yaw_rad;
	sketch.view.camera = place + sketch.view.mount_forward_m * Eigen::Vector2d(std::cos(yaw_rad), std::sin(yaw_rad));
	sketch.floor_use.take(discOutline(place, sketch.robot.radius_m + kAround_m));
}

void keepInSight(Sketch& sketch, const Subject& subject)
{
	constexpr double kLow_m = 0.45, kStops_m = 0.02;
	const Eigen::Vector2d before = kStops_m * subject.frame.outward();
	sketch.floor_use.keepLow({sketch.view.camera, subject.low() + before, subject.high() + before},
	                         sketch.random.chance(0.3) ? kLow_m : 0.0);
}

Region regionOf(const Subject& subject, const Span& z, const Span& share)
{
	Region region;
	region.frame = subject.frame;
	region.along = subject.along;
	region.z = z;
	region.share = share;
	return region;
}
}  // namespace explore::simulation
