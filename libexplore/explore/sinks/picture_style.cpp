#include <explore/sinks/picture_style.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
Eigen::Vector3d onFloor(const std::optional<Ground>& ground, const Eigen::Vector3d& point)
{
	if (!ground || std::abs(ground->plane.normal.z()) < 0.1) return {point.x(), point.y(), 0.0};
	return point - Eigen::Vector3d(0, 0, ground->plane.signedDistance(point) / ground->plane.normal.z());
}
}  // namespace

mrpt::img::TColor style::depthColor(double share)
{
	static const std::array<Eigen::Vector3d, 5> kAnchors{Eigen::Vector3d(238, 232, 213), Eigen::Vector3d(160, 193, 189),
	                                                     Eigen::Vector3d(86, 143, 165), Eigen::Vector3d(49, 92, 137),
	                                                     Eigen::Vector3d(33, 44, 88)};
	const double at = std::clamp(share, 0.0, 1.0) * (kAnchors.size() - 1);
	const auto below = std::min(static_cast<std::size_t>(at), kAnchors.size() - 2);
	const double t = at - static_cast<double>(below);
	const Eigen::Vector3d mixed = (1.0 - t) * kAnchors[below] + t * kAnchors[below + 1];
	return {static_cast<std::uint8_t>(mixed.x()), static_cast<std::uint8_t>(mixed.y()),
	        static_cast<std::uint8_t>(mixed.z())};
}

Eigen::Vector3d floorPoint(const std::optional<Ground>& ground, double heading_rad, double distance_m)
{
	return onFloor(ground, {distance_m * std::cos(heading_rad), distance_m * std::sin(heading_rad), 0.0});
}

std::vector<HeadingArrow> headingArrows(const StepResult& result)
{
	constexpr double kStart_m = 0.6;
	std::vector<HeadingArrow> arrows;
	const auto add = [&](HeadingKind kind, const std::optional<double>& heading_rad, double reach_m)
	{
		if (!heading_rad) return;
		const auto& ground = result.percepts.ground;
		arrows.push_back({kind, floorPoint(ground, *heading_rad, kStart_m), floorPoint(ground, *heading_rad, reach_m)});
	};
	const Headings& headings = result.decision.headings;
	add(HeadingKind::vanishing_point, headings.vanishing_point_rad, 3.0);
	add(HeadingKind::door, headings.door_rad, 2.5);
	add(HeadingKind::avoid, headings.avoid_rad, 2.2);
	add(HeadingKind::chosen, headings.chosen_rad, 1.9);
	return arrows;
}

std::array<Eigen::Vector3d, 4> doorCorners(const Door& door, const std::optional<Ground>& ground)
{
	const Eigen::Vector3d up = ground ? ground->plane.normal : Eigen::Vector3d::UnitZ();
	const Eigen::Vector3d half = 0.5 * door.width_m * up.cross(door.normal).normalized();
	const Eigen::Vector3d foot = onFloor(ground, door.center);
	const Eigen::Vector3d rise = door.height_m.value_or(kUsualDoorHeight_m) * up;
	return {foot - half, foot + half, foot + half + rise, foot - half + rise};
}

DoorMark markOf(const Door& door, const std::optional<Ground>& ground)
{
	return {doorCorners(door, ground), door.normal, style::kDoor, doorLabel(door)};
}

std::string doorLabel(const Door& door)
{
	const std::string name = door.verdict == Verdict::open ? "door" : std::string(nameOf(door.verdict));
	return mrpt::format("%s %.2f m", name.c_str(), door.width_m);
}
}  // namespace explore
