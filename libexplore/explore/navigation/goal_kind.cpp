#include <explore/navigation/goal_choice.h>
#include <explore/navigation/goal_kind.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kHere_m = 0.25;
/** A corridor goes on beyond where it was seen; one with a wall on one side alone is so wide. */
constexpr double kBeyondEnd_m = 3.0, kUsualWidth_m = 2.0;
/** A way passes a door that it crosses the wall at, this far from the opening's middle beyond half its width. */
constexpr double kBesideDoor_m = 0.1;

/** Whether the straight way from `a` to `b` crosses the opening. */
bool crosses(const DoorPlace& door, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
	const double before = door.normal().dot(a - door.center_in_map), after = door.normal().dot(b - door.center_in_map);
	if ((before > 0.0) == (after > 0.0)) return false;
	const Eigen::Vector2d at = a + (b - a) * (before / (before - after));
	return std::abs(door.along().dot(at - door.center_in_map)) <= 0.5 * door.width_m + kBesideDoor_m;
}

std::optional<int> doorOnWay(const std::vector<Eigen::Vector2d>& way, const FrontierMemory& memory,
                             const RobotConfig& robot)
{
	for (std::size_t i = 1; i < way.size(); ++i)
		for (const DoorTrack& track : memory.doors.tracks)
		{
			if (!track.existence.confirmed || track.visited || !crosses(track.place, way[i - 1], way[i])) continue;
			if (fitsThrough(doorOf(track, Eigen::Isometry3d::Identity()), robot)) return track.number;
		}
	return std::nullopt;
}

std::optional<int> corridorAt(const Eigen::Vector2d& point, const FrontierMemory& memory)
{
	for (const CorridorTrack& track : memory.corridors.tracks)
	{
		if (!track.existence.confirmed) continue;
		const Eigen::Vector2d off = point - track.point_in_map;
		const Eigen::Vector2d across(-track.direction().y(), track.direction().x());
		const double along_m = track.direction().dot(off);
		const bool inside = along_m > track.from_m - kBeyondEnd_m && along_m < track.to_m + kBeyondEnd_m;
		if (inside && std::abs(across.dot(off)) <= 0.5 * track.width_m.value_or(kUsualWidth_m)) return track.number;
	}
	return std::nullopt;
}
}  // namespace

GoalName nameOf(const LookTarget& target, const std::vector<CellIndex>& way, const PlanMap& map,
                const FrontierMemory& memory, const RobotConfig& robot)
{
	std::vector<Eigen::Vector2d> points;
	points.reserve(way.size() + 1);
	for (const CellIndex cell : way) points.emplace_back(map.middleOf(cell).head<2>());
	points.emplace_back(target.frontier_in_map.head<2>());
	if (const auto door = doorOnWay(points, memory, robot)) return {GoalKind::door, door};
	if (const auto corridor = corridorAt(target.frontier_in_map.head<2>(), memory))
		return {GoalKind::corridor, corridor};
	if (target.travel_m <= kHere_m) return {GoalKind::look, std::nullopt};
	return {GoalKind::frontier, std::nullopt};
}
}  // namespace explore
