#include <explore/memory/door_place.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore
{
Eigen::Vector2d DoorPlace::normal() const
{
	return {std::cos(normal_rad), std::sin(normal_rad)};
}

Eigen::Vector2d DoorPlace::along() const
{
	return {std::sin(normal_rad), -std::cos(normal_rad)};
}

Eigen::Vector3d DoorPlace::point(double along_m, double above_floor_m) const
{
	const Eigen::Vector2d on_plan = center_in_map + along_m * along();
	return {on_plan.x(), on_plan.y(), floor_m + above_floor_m};
}

DoorPlace placeOf(const Door& door_in_robot, const Eigen::Isometry3d& map_from_robot)
{
	const Eigen::Vector3d center = map_from_robot * door_in_robot.center;
	DoorPlace place;
	place.center_in_map = center.head<2>();
	place.normal_rad = azimuthOf(map_from_robot.linear() * door_in_robot.normal);
	place.width_m = door_in_robot.width_m;
	place.floor_m = center.z() - 0.5 * door_in_robot.height_m.value_or(kUsualDoorHeight_m);
	place.height_m = door_in_robot.height_m;
	return place;
}

double axisDifference(double a_rad, double b_rad)
{
	return std::remainder(a_rad - b_rad, std::numbers::pi);
}

DoorOverlap overlapOf(const DoorPlace& a, const DoorPlace& b)
{
	const Eigen::Vector2d offset = b.center_in_map - a.center_in_map;
	const double half_a = 0.5 * a.width_m;
	const double half_b = 0.5 * b.width_m * std::abs(a.along().dot(b.along()));
	const double at = offset.dot(a.along());
	const double shared_m = std::min(half_a, at + half_b) - std::max(-half_a, at - half_b);
	const double narrower_m = 2 * std::min(half_a, half_b);
	DoorOverlap overlap;
	overlap.share = narrower_m > 0 ? std::clamp(shared_m / narrower_m, 0.0, 1.0) : 0.0;
	overlap.across_m = std::abs(offset.dot(a.normal()));
	overlap.angle_rad = std::abs(axisDifference(a.normal_rad, b.normal_rad));
	overlap.distance_m = offset.norm();
	return overlap;
}

bool leadsThrough(const DoorPlace& place, const Eigen::Vector2d& from_in_map, const Eigen::Vector2d& to_in_map)
{
	const double from_m = (from_in_map - place.center_in_map).dot(place.normal());
	const double to_m = (to_in_map - place.center_in_map).dot(place.normal());
	if ((from_m < 0) == (to_m < 0)) return false;
	const Eigen::Vector2d crossing = from_in_map + from_m / (from_m - to_m) * (to_in_map - from_in_map);
	return std::abs((crossing - place.center_in_map).dot(place.along())) < 0.5 * place.width_m;
}

double turnOf(const Eigen::Isometry3d& motion)
{
	return std::atan2(motion.linear()(1, 0), motion.linear()(0, 0));
}

DoorPlace moved(const DoorPlace& place, const Eigen::Isometry3d& new_map_from_map)
{
	DoorPlace result = place;
	const Eigen::Vector3d center = new_map_from_map * place.point(0, 0);
	result.center_in_map = center.head<2>();
	result.floor_m = center.z();
	result.normal_rad = wrapToPi(place.normal_rad + turnOf(new_map_from_map));
	return result;
}
}  // namespace explore
