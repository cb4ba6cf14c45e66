// Doors whose place is known, and what a robot that drives past them would report of them.
#pragma once

#include <explore/core/geometry.h>
#include <explore/memory/door_tracks.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace explore::test
{
struct KnownDoor
{
	Eigen::Vector2d center_in_map;
	double normal_rad = 0;
	double width_m = 0.9;
	Verdict verdict = Verdict::open;
};

/** Map axes; the camera looks along the robot's x. */
inline Eigen::Isometry3d robotAt(double x_m, double y_m, double yaw_rad)
{
	Eigen::Isometry3d map_from_robot = Eigen::Isometry3d::Identity();
	map_from_robot.translation() = Eigen::Vector3d(x_m, y_m, 0);
	map_from_robot.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
	return map_from_robot;
}

/** The camera 0.5 m above the robot's origin. */
inline Eigen::Isometry3d mount()
{
	Eigen::Isometry3d robot_from_camera = Eigen::Isometry3d::Identity();
	robot_from_camera.translation().z() = 0.5;
	return robot_from_camera;
}

/** The same numbers everywhere. */
class Dice
{
public:
	explicit Dice(std::uint32_t seed) : m_random(seed) {}
	double uniform(double low, double high)
	{
		return low + (high - low) * (static_cast<double>(m_random()) / 4294967296.0);
	}
	bool chance(double probability) { return uniform(0, 1) < probability; }
	/** N(0, 1), nearly: Irwin and Hall. */
	double gauss()
	{
		double sum = -6;
		for (int i = 0; i < 12; ++i) sum += uniform(0, 1);
		return sum;
	}

private:
	std::mt19937 m_random;
};

/** A perfect report, in the robot frame. */
inline Door reportOf(const KnownDoor& door, const Eigen::Isometry3d& map_from_robot)
{
	const Eigen::Isometry3d robot_from_map = map_from_robot.inverse();
	Door report;
	report.center = robot_from_map * Eigen::Vector3d(door.center_in_map.x(), door.center_in_map.y(), 1.0);
	report.normal = robot_from_map.linear() * Eigen::Vector3d(std::cos(door.normal_rad), std::sin(door.normal_rad), 0);
	if (report.normal.dot(report.center) > 0) report.normal = -report.normal;
	report.width_m = door.width_m;
	report.height_m = 2.0;
	report.verdict = door.verdict;
	const bool passable = isPassable(door.verdict);
	report.clear_width_m = passable ? door.width_m : 0.0;
	report.confidence = passable ? 0.95 : 0.05;
	return report;
}

/** Both jambs 0.8–5 m away and within 57° of view, seen at less than 70° from the front. */
inline bool isInView(const DoorPlace& door, const Eigen::Isometry3d& map_from_robot)
{
	const Eigen::Vector2d camera = map_from_robot.translation().head<2>();
	const Eigen::Vector2d sight = door.center_in_map - camera;
	if (std::abs(sight.normalized().dot(door.normal())) < std::cos(70 * kDegree_rad)) return false;
	for (const double side : {-0.5, 0.5})
	{
		const Eigen::Vector3d jamb = map_from_robot.inverse() * door.point(side * door.width_m, 0);
		if (jamb.head<2>().norm() < 0.8 || jamb.head<2>().norm() > 5.0) return false;
		if (std::abs(std::atan2(jamb.y(), jamb.x())) > 28.5 * kDegree_rad) return false;
	}
	return true;
}

inline DoorPlace placeOf(const KnownDoor& door)
{
	return {.center_in_map = door.center_in_map, .normal_rad = door.normal_rad, .width_m = door.width_m};
}

/** A report with errors as a depth camera's grow with range. */
inline Door noisyReport(const KnownDoor& door, const Eigen::Isometry3d& map_from_robot, Dice& dice)
{
	Door report = reportOf(door, map_from_robot);
	const double range_m = report.center.head<2>().norm();
	const double sigma_m = 0.02 + 0.003 * range_m * range_m;
	report.center += Eigen::Vector3d(sigma_m * dice.gauss(), sigma_m * dice.gauss(), 0.01 * dice.gauss());
	report.normal = Eigen::AngleAxisd(2 * kDegree_rad * dice.gauss(), Eigen::Vector3d::UnitZ()) * report.normal;
	report.width_m += 1.4 * sigma_m * dice.gauss();
	report.clear_width_m = isPassable(report.verdict) ? report.width_m : 0.0;
	return report;
}

/** A look with everything in it: the doors must outlive it. */
inline DoorLook lookAt(const std::vector<Door>& doors_in_robot, const Eigen::Isometry3d& map_from_robot, double t_s)
{
	DoorLook look;
	look.doors_in_robot = doors_in_robot;
	look.map_from_robot = map_from_robot;
	look.robot_from_camera = mount();
	look.t_s = t_s;
	look.view = [map_from_robot](const DoorPlace& place) {
		return isInView(place, map_from_robot) ? std::optional(DoorView{0, 0}) : std::nullopt;
	};
	return look;
}
}  // namespace explore::test
