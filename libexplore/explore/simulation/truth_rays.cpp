#include <explore/core/geometry.h>
#include <explore/simulation/corridor_truth.h>
#include <explore/simulation/door_passage.h>
#include <explore/simulation/door_visibility.h>
#include <explore/simulation/free_paths.h>
#include <explore/simulation/truth_rays.h>

#include <algorithm>

namespace explore::simulation
{
namespace
{
std::vector<TruthDoor> doorsInView(const RayScene& scene, const TruthView& view, const RobotConfig& robot)
{
	std::vector<TruthDoor> doors;
	for (const DoorLabel& label : scene.world().doors)
	{
		auto door = doorInView(label, view);
		if (!door) continue;
		const Passage passage = passageOf(label, scene, robot);
		constexpr double kHeightWithoutLintel_m = 2.0;
		door->id = label.id;
		door->height_m = label.height_m;
		door->center_in_map = label.floor_center_in_map +
		                      0.5 * label.height_m.value_or(kHeightWithoutLintel_m) * Eigen::Vector3d::UnitZ();
		door->width_m = label.width_m;
		door->clear_width_m = passage.clear_width_m;
		door->verdict = passage.verdict;
		door->passable = passage.passable;
		doors.push_back(std::move(*door));
	}
	return doors;
}

/** Whether a part of the upright cylinder is seen: rays to its middle and to both sides, at three heights. What is
 *  nearer to the point than the radius is the obstacle itself. */
bool inView(const TruthObstacle& obstacle, const TruthView& view)
{
	const Eigen::Vector3d to_obstacle = obstacle.center_in_map - view.cameraInMap();
	const Eigen::Vector3d across = Eigen::Vector3d(-to_obstacle.y(), to_obstacle.x(), 0.0).normalized();
	for (const double side : {-0.8, 0.0, 0.8})
		for (const double height : {-0.4, 0.0, 0.4})
		{
			const Eigen::Vector3d point = obstacle.center_in_map + side * obstacle.radius_m * across +
			                              height * obstacle.height_m * Eigen::Vector3d::UnitZ();
			if (view.sightOf(point, {}, obstacle.radius_m + 0.02) >= PointSight::glass) return true;
		}
	return false;
}

std::vector<TruthObstacle> obstaclesInView(const RayScene& scene, const TruthView& view)
{
	const World& world = scene.world();
	std::vector<TruthObstacle> obstacles;
	const auto add = [&](const std::string& kind, const Eigen::Vector3d& foot, double radius_m, double height_m)
	{
		TruthObstacle obstacle{kind, foot + 0.5 * height_m * Eigen::Vector3d::UnitZ(), radius_m, height_m};
		if (inView(obstacle, view)) obstacles.push_back(std::move(obstacle));
	};
	for (const ObstacleLabel& label : world.obstacles)
		add(label.kind, label.floor_center_in_map, label.radius_m, label.height_m);
	const std::vector<Eigen::Isometry3d> map_from_body = scene.placement();
	for (std::size_t i = 0; i < world.moving.size(); ++i)
		add(world.moving[i].kind, map_from_body[i].translation(), world.moving[i].radius_m, world.moving[i].height_m);
	return obstacles;
}
}  // namespace

TruthFrame truthAt(const RayScene& scene, const TruthCamera& camera, const RobotConfig& robot,
                   const mrpt::poses::CPose3D& map_from_robot)
{
	const TruthView view(scene, camera.intrinsics, isometryOf(map_from_robot + camera.robot_from_camera));
	TruthFrame frame;
	frame.map_from_robot = map_from_robot;
	frame.doors = doorsInView(scene, view, robot);
	frame.corridor = corridorInView(scene, view);
	frame.obstacles = obstaclesInView(scene, view);
	frame.free_paths = freePaths(scene, robot, map_from_robot);
	return frame;
}
}  // namespace explore::simulation
