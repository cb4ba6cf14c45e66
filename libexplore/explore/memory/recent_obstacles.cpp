#include <explore/core/geometry.h>
#include <explore/memory/recent_obstacles.h>

#include <cmath>

namespace explore
{
namespace
{
constexpr double kCell_m = 0.05;
/** Beyond the least range of common depth cameras (0.4–0.8 m) by what a person walks in half a second. */
constexpr double kNear_m = 1.2;
constexpr double kKept_s = 10.0;
/** A person from the chest to the back, and points within it. */
constexpr std::array<double, 3> kBody_m{0.1, 0.2, 0.3};
/** What is measured this much farther lies behind. */
constexpr double kBehind_m = 0.1;

std::array<int, 3> cellOf(const Eigen::Vector3d& place_in_map, RobotKind kind)
{
	const auto index = [](double value) { return static_cast<int>(std::floor(value / kCell_m)); };
	return {index(place_in_map.x()), index(place_in_map.y()), kind == RobotKind::ground ? 0 : index(place_in_map.z())};
}

bool seesThrough(const DepthImage& image, const Eigen::Vector3d& point_in_camera)
{
	const auto pixel = pixelOfPoint(image.intrinsics, point_in_camera);
	if (!pixel) return false;
	const auto u = std::lround(pixel->x()), v = std::lround(pixel->y());
	if (u < 0 || v < 0 || u >= image.intrinsics.width_px || v >= image.intrinsics.height_px) return false;
	return image.at(static_cast<int>(u), static_cast<int>(v)) > point_in_camera.x() + kBehind_m;
}

/** Whether the map has nothing there but free space: not noise of a wall either. */
bool isKnownFree(const BodyLayers& layers, const Eigen::Vector3d& place_in_map)
{
	const LayerFrame& frame = layers.frame();
	const LayerCell middle = frame.cellAt(place_in_map.head<2>(), frame.nearestLayer(place_in_map.z()));
	for (int row = middle.row - 1; row <= middle.row + 1; ++row)
		for (int column = middle.column - 1; column <= middle.column + 1; ++column)
			if (layers.stateOf({column, row, middle.layer}) != CellState::free) return false;
	return true;
}
}  // namespace

void update(RecentObstacles& recent, const DepthFrame& frame, const PointCloud& obstacles_in_robot,
            const BodyLayers& layers, const RobotConfig& robot)
{
	const double now_s = mrpt::Clock::toDouble(frame.timestamp);
	const Eigen::Isometry3d map_from_robot = isometryOf(frame.map_from_robot);
	const Eigen::Isometry3d map_from_camera = map_from_robot * isometryOf(frame.robot_from_camera);
	const Eigen::Isometry3d camera_from_map = map_from_camera.inverse();
	const auto add = [&](const Eigen::Vector3d& place_in_map) {
		recent.cells.insert_or_assign(cellOf(place_in_map, robot.kind), RecentObstacle{place_in_map, now_s});
	};
	std::erase_if(recent.cells,
	              [&](const auto& item)
	              {
		              const RecentObstacle& old = item.second;
		              return now_s - old.seen_at_s > kKept_s ||
		                     (!frame.image.empty() && seesThrough(frame.image, camera_from_map * old.place_in_map));
	              });
	for (std::size_t i = 0; i < obstacles_in_robot.size(); ++i)
	{
		const Eigen::Vector3d point = obstacles_in_robot[i].cast<double>();
		if (point.head<2>().norm() > kNear_m) continue;
		const Eigen::Vector3d place_in_map = map_from_robot * point;
		add(place_in_map);
		const bool came_lately = isKnownFree(layers, place_in_map);
		const Eigen::Vector3d ray = (place_in_map - map_from_camera.translation()).normalized();
		for (const double depth_m : kBody_m)
		{
			const Eigen::Vector3d behind_in_map = place_in_map + depth_m * ray;
			// What stays gets into the map, its body does not.
			if (came_lately || recent.cells.contains(cellOf(behind_in_map, robot.kind))) add(behind_in_map);
		}
	}
}

PointCloud inRobotFrame(const RecentObstacles& recent, const Eigen::Isometry3d& map_from_robot)
{
	const Eigen::Isometry3d robot_from_map = map_from_robot.inverse();
	PointCloud points;
	for (const auto& [cell, obstacle] : recent.cells)
		points.push_back((robot_from_map * obstacle.place_in_map).cast<float>());
	return points;
}
}  // namespace explore
