#include "scene_approach.h"

#include <explore/core/geometry.h>
#include <explore/simulation/robot_body.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace explore::simulation
{
namespace
{
using mrpt::poses::CPose3D;

/** Where to go, on the floor plan: the middle of the doorway, and a place before it. */
struct Aim
{
	Eigen::Vector2d door, before_door;
};

std::optional<Aim> aimOf(const World& world, const Promise& promise)
{
	constexpr double kBefore_m = 0.9;
	if (promise.visible_doors.empty()) return std::nullopt;
	const auto label = std::ranges::find(world.doors, promise.visible_doors.front(), &DoorLabel::id);
	if (label == world.doors.end()) return std::nullopt;
	const Eigen::Vector2d center = label->floor_center_in_map.head<2>(), normal = label->normal_in_map.head<2>();
	// The robot begins at the origin.
	const double side = normal.dot(-center) >= 0 ? 1.0 : -1.0;
	return Aim{center, center + kBefore_m * side * normal};
}

double headingTo(const Aim& aim, const CPose3D& map_from_robot)
{
	constexpr double kThere_m = 0.5;
	const Eigen::Vector2d robot(map_from_robot.x(), map_from_robot.y());
	const Eigen::Vector2d way = ((aim.before_door - robot).norm() > kThere_m ? aim.before_door : aim.door) - robot;
	return std::atan2(way.y(), way.x());
}

/** The next place; on the spot where there is no room ahead. */
CPose3D nextPose(const Looker& looker, const std::optional<Aim>& aim, const CPose3D& pose, Random& random)
{
	constexpr double kMost_rad = 10 * kDegree_rad, kLeast_rad = 3 * kDegree_rad, kMargin_m = 0.06;
	const double sway_rad = random.uniform(-kLeast_rad, kLeast_rad), step_m = random.uniform(0.06, 0.25);
	const double turn_rad = aim ? wrapToPi(headingTo(*aim, pose) - pose.yaw()) : 0.0;
	const double yaw_rad = pose.yaw() + std::clamp(turn_rad, -kMost_rad, kMost_rad) + sway_rad;
	const bool flies = looker.robot.kind == RobotKind::mav;
	const double lean_rad = (flies ? 1.5 : 0.2) * kDegree_rad, climb_m = flies ? random.uniform(-0.02, 0.02) : 0.0;
	const double pitch_rad = pose.pitch() + random.uniform(-lean_rad, lean_rad);
	const double roll_rad = pose.roll() + random.uniform(-lean_rad, lean_rad);
	CPose3D ahead(pose.x() + step_m * std::cos(yaw_rad), pose.y() + step_m * std::sin(yaw_rad), pose.z() + climb_m,
	              yaw_rad, pitch_rad, roll_rad);
	if (!looker.touches(ahead, kMargin_m)) return ahead;
	const double on_spot_rad = (turn_rad >= 0 ? 1.0 : -1.0) * (kLeast_rad + std::abs(sway_rad));
	return {pose.x(), pose.y(), pose.z(), pose.yaw() + on_spot_rad, pose.pitch(), pose.roll()};
}
}  // namespace

bool Looker::touches(const CPose3D& map_from_robot, double margin_m) const
{
	RobotConfig body = robot;
	body.height_m = body_height_m;
	const VerticalCylinder cylinder = bodyAt(body, {map_from_robot.x(), map_from_robot.y(), map_from_robot.z()});
	return scene.touchesCylinder(cylinder.base, cylinder.radius_m + margin_m, cylinder.height_m);
}

std::vector<PlannedLook> planApproach(const Looker& looker, const Promise& promise, const CPose3D& first, int looks,
                                      std::uint64_t seed)
{
	Random random(seed);
	const std::optional<Aim> aim = aimOf(looker.scene.world(), promise);
	std::vector<PlannedLook> planned = {{0.0, first}};
	while (static_cast<int>(planned.size()) < looks)
	{
		const double t_s = planned.back().t_s + random.uniform(0.2, 0.5);
		planned.push_back({t_s, nextPose(looker, aim, planned.back().map_from_robot, random)});
	}
	return planned;
}
}  // namespace explore::simulation
