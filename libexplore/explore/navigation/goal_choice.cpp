#include <explore/navigation/goal_choice.h>
#include <explore/navigation/level_frame.h>

#include <algorithm>

namespace explore
{
namespace
{
constexpr double kDoorMargin_m = 0.10;

const Door* nearestDoor(const std::vector<Door>& doors, const Eigen::Matrix3d& level_from_robot,
                        const RobotConfig& robot)
{
	const Door* nearest = nullptr;
	double nearest_m = 0.0;
	for (const Door& door : doors)
	{
		const double distance_m = (level_from_robot * door.center).head<2>().norm();
		if (!fitsThrough(door, robot) || (nearest != nullptr && distance_m >= nearest_m)) continue;
		nearest = &door;
		nearest_m = distance_m;
	}
	return nearest;
}

const VanishingPoint* strongest(const std::vector<VanishingPoint>& points)
{
	const auto found =
	    std::max_element(points.begin(), points.end(),
	                     [](const VanishingPoint& a, const VanishingPoint& b) { return a.inliers < b.inliers; });
	return found == points.end() ? nullptr : &*found;
}
}  // namespace

bool fitsThrough(const Door& door, const RobotConfig& robot)
{
	const bool passable =
	    door.verdict == Verdict::open || door.verdict == Verdict::ajar || door.verdict == Verdict::passage;
	const bool flies = robot.kind == RobotKind::mav;
	const double needed_height_m = flies ? robot.min_altitude_m + 0.5 * robot.height_m : robot.height_m;
	const bool high = !door.height_m || *door.height_m >= needed_height_m;
	return passable && high && door.clear_width_m >= 2.0 * robot.radius_m + kDoorMargin_m;
}

GoalChoice chooseGoal(const Percepts& percepts, const RobotConfig& robot)
{
	const auto ground = percepts.ground ? std::optional(percepts.ground->plane) : std::nullopt;
	const Eigen::Matrix3d level_from_robot = levelFrame(ground).level_from_robot;
	GoalChoice choice;
	if (const VanishingPoint* point = strongest(percepts.vanishing_points))
	{
		choice.vanishing_point_rad = azimuthOf(level_from_robot * point->point);
		choice.goal = {GoalKind::corridor, point->track, point->point};
	}
	if (const Door* door = nearestDoor(percepts.doors, level_from_robot, robot))
	{
		choice.door_rad = azimuthOf(level_from_robot * door->center);
		choice.goal = {GoalKind::door, door->track, door->center};
	}
	choice.desired_rad = choice.door_rad.value_or(choice.vanishing_point_rad.value_or(0.0));
	return choice;
}
}  // namespace explore
