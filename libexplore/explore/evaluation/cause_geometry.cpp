#include <explore/core/geometry.h>
#include <explore/evaluation/cause_geometry.h>

#include <algorithm>
#include <cmath>

namespace explore::evaluation
{
namespace
{
constexpr double kGroundTilt_rad = 5 * kDegree_rad, kGroundOffset_m = 0.10;
constexpr double kWallTilt_rad = 10 * kDegree_rad, kWallOffset_m = 0.20;
constexpr double kBesideJamb_m = 0.10;
constexpr double kUsualHeight_m = 2.0;
constexpr int kJambSteps = 20;

Plane inMap(const Plane& plane_in_robot, const Eigen::Isometry3d& map_from_robot)
{
	const Eigen::Vector3d normal = map_from_robot.linear() * plane_in_robot.normal;
	return {normal, plane_in_robot.d_m - normal.dot(map_from_robot.translation())};
}

Eigen::Vector3d lifted(const Eigen::Vector2d& place, double z_m)
{
	return {place.x(), place.y(), z_m};
}
}  // namespace

Eigen::Vector3d footOf(const TruthDoor& door)
{
	return door.center_in_map - 0.5 * door.height_m.value_or(kUsualHeight_m) * Eigen::Vector3d::UnitZ();
}

std::array<Eigen::Vector2d, 2> jambsOf(const Eigen::Vector2d& center, const Eigen::Vector2d& normal, double width_m)
{
	const Eigen::Vector2d along(-normal.y(), normal.x());
	return {center - 0.5 * width_m * along, center + 0.5 * width_m * along};
}

CauseGeometry::CauseGeometry(const CauseInput& input)
    : m_input(input),
      m_map_from_robot(isometryOf(input.truth.map_from_robot)),
      m_map_from_camera(m_map_from_robot * isometryOf(input.robot_from_camera))
{
}

bool CauseGeometry::groundWrong(const Eigen::Vector3d& foot_in_map) const
{
	const auto& ground = m_input.percepts.ground;
	if (!ground) return paperMethod();
	const Plane plane = inMap(ground->plane, m_map_from_robot);
	return angleBetweenAxes(plane.normal, Eigen::Vector3d::UnitZ()) > kGroundTilt_rad ||
	       std::abs(plane.signedDistance(foot_in_map)) > kGroundOffset_m;
}

int CauseGeometry::wallsAt(const Eigen::Vector2d& center, const Eigen::Vector2d& normal) const
{
	const Eigen::Vector3d place = lifted(center, m_map_from_robot.translation().z());
	return static_cast<int>(std::ranges::count_if(m_input.percepts.walls,
	                                              [&](const Wall& wall)
	                                              {
		                                              const Plane plane = inMap(wall.plane, m_map_from_robot);
		                                              return angleBetweenAxes(plane.normal, lifted(normal, 0.0)) <=
		                                                         kWallTilt_rad &&
		                                                     std::abs(plane.signedDistance(place)) <= kWallOffset_m;
	                                              }));
}

bool CauseGeometry::paperMethod() const
{
	return m_input.perception.method == PerceptionMethod::paper;
}

bool CauseGeometry::besideImage(const std::array<Eigen::Vector2d, 2>& jambs, double floor_m) const
{
	const DoorGapConfig& gaps = m_input.perception.door_gaps;
	const Eigen::Vector2d outward = kBesideJamb_m * (jambs[1] - jambs[0]).normalized();
	const auto seen_at = [&](double height_m)
	{
		return inImage(lifted(jambs[0] - outward, floor_m + height_m)) &&
		       inImage(lifted(jambs[1] + outward, floor_m + height_m));
	};
	if (paperMethod()) return !seen_at(gaps.scan_height_m) || !seen_at(gaps.second_scan_height_m);
	int seen = 0;
	for (int step = 0; step < kJambSteps; ++step) seen += seen_at(kUsualHeight_m * (step + 0.5) / kJambSteps) ? 1 : 0;
	return 2 * seen < kJambSteps;
}

bool CauseGeometry::behindObstacle(const std::array<Eigen::Vector2d, 2>& jambs) const
{
	constexpr int kRays = 12;
	const Eigen::Vector2d from = camera(), outward = kBesideJamb_m * (jambs[1] - jambs[0]).normalized();
	const Eigen::Vector2d first = jambs[0] - outward, last = jambs[1] + outward;
	for (int i = 0; i <= kRays; ++i)
	{
		const Eigen::Vector2d ray = first + (last - first) * i / kRays - from;
		for (const TruthObstacle& obstacle : m_input.truth.obstacles)
		{
			const Eigen::Vector2d to = obstacle.center_in_map.head<2>() - from;
			const double along = to.dot(ray) / ray.squaredNorm();
			if (along > 0.0 && along < 1.0 && (to - along * ray).norm() < obstacle.radius_m) return true;
		}
	}
	return false;
}

double CauseGeometry::shareInImage(const TruthDoor& door) const
{
	constexpr int kSteps = 12;
	const Eigen::Vector3d foot = footOf(door);
	const auto jambs = jambsOf(foot.head<2>(), door.normal_in_map.head<2>(), door.width_m);
	const double height_m = door.height_m.value_or(kUsualHeight_m);
	int inside = 0;
	for (int i = 0; i < kSteps; ++i)
		for (int j = 0; j < kSteps; ++j)
			inside += inImage(lifted(jambs[0] + (jambs[1] - jambs[0]) * (i + 0.5) / kSteps,
			                         foot.z() + height_m * (j + 0.5) / kSteps))
			              ? 1
			              : 0;
	return static_cast<double>(inside) / (kSteps * kSteps);
}

double CauseGeometry::floorNear(const Eigen::Vector2d& place) const
{
	const auto distance = [&](const TruthDoor& door) { return (door.center_in_map.head<2>() - place).norm(); };
	const auto nearest = std::ranges::min_element(m_input.truth.doors, {}, distance);
	return nearest == m_input.truth.doors.end() ? 0.0 : footOf(*nearest).z();
}

bool CauseGeometry::inImage(const Eigen::Vector3d& point_in_map) const
{
	const CameraIntrinsics& camera = m_input.intrinsics;
	const auto pixel = pixelOfPoint(camera, m_map_from_camera.inverse() * point_in_map);
	return pixel && pixel->x() >= 0 && pixel->y() >= 0 && pixel->x() <= camera.width_px - 1 &&
	       pixel->y() <= camera.height_px - 1;
}
}  // namespace explore::evaluation
