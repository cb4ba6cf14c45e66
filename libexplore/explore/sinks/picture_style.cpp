#include <explore/sinks/picture_style.h>
#include <mrpt/core/bits_math.h>
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

mrpt::img::TColor style::heightColor(double height_m)
{
	constexpr double kTop_m = 2.5, kDarkest = 0.55;  // pale at the top, not too dark for the panel at the floor
	return depthColor(kDarkest * (1.0 - height_m / kTop_m));
}

mrpt::img::TColor style::verdictColor(Verdict verdict)
{
	switch (verdict)
	{
		case Verdict::open:
			return {0, 158, 115};
		case Verdict::ajar:
			return {240, 228, 66};
		case Verdict::closed:
			return {213, 94, 0};
		case Verdict::blocked:
			return {230, 159, 0};
		case Verdict::passage:
			return {86, 180, 233};
		case Verdict::drop:
			return {204, 121, 167};
		case Verdict::partial:
			return {0, 114, 178};
		case Verdict::unknown:
			break;
	}
	return {138, 147, 163};
}

mrpt::img::TColor style::headingColor(HeadingKind kind)
{
	switch (kind)
	{
		case HeadingKind::vanishing_point:
			return kVanishingPoint;
		case HeadingKind::door:
			return kDoorHeading;
		case HeadingKind::avoid:
			return kAvoid;
		case HeadingKind::chosen:
			break;
	}
	return kChosen;
}

std::string_view nameOf(HeadingKind kind)
{
	switch (kind)
	{
		case HeadingKind::vanishing_point:
			return "vanishing_point";
		case HeadingKind::door:
			return "door";
		case HeadingKind::avoid:
			return "avoid";
		case HeadingKind::chosen:
			break;
	}
	return "chosen";
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

std::string decisionText(const Decision& decision)
{
	if (decision.stop) return "STOP: " + std::string(nameOf(decision.stop_reason));
	return mrpt::format("%+.0f deg, free %.1f m, %.2f m/s", mrpt::RAD2DEG(decision.headings.chosen_rad.value_or(0.0)),
	                    decision.open_path_m, decision.command.velocity_mps.norm());
}
}  // namespace explore
