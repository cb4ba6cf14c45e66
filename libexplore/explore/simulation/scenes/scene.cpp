#include "scene.h"

#include <explore/simulation/scenes/scene_approach.h>
#include <explore/simulation/scenes/scene_promise.h>
#include <explore/simulation/scenes/scene_walls.h>
#include <explore/simulation/truth_rays.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace explore::simulation
{
namespace
{
constexpr std::uint64_t kTries = 500;

/** Puts all of the world and its labels where `map_from_building` says; a turn about z. */
void move(World& world, const Eigen::Isometry3d& map_from_building)
{
	const Eigen::Isometry3f moved = map_from_building.cast<float>();
	for (Eigen::Vector3f& vertex : world.mesh.vertices) vertex = moved * vertex;
	const auto on_plan = [&map_from_building](Eigen::Vector2d& point)
	{ point = (map_from_building * Eigen::Vector3d(point.x(), point.y(), 0)).head<2>(); };
	for (DoorLabel& door : world.doors)
	{
		door.floor_center_in_map = map_from_building * door.floor_center_in_map;
		door.normal_in_map = map_from_building.linear() * door.normal_in_map;
	}
	for (CorridorLabel& corridor : world.corridors) on_plan(corridor.start_in_map), on_plan(corridor.end_in_map);
	for (ObstacleLabel& obstacle : world.obstacles)
		obstacle.floor_center_in_map = map_from_building * obstacle.floor_center_in_map;
}

mrpt::poses::CPose3D mountOf(const Viewpoint& view, RobotKind kind)
{
	const double up_m = kind == RobotKind::mav ? 0.0 : view.camera_height_m;
	return {view.mount_forward_m, 0, up_m, 0, view.mount_pitch_rad, view.mount_roll_rad};
}

mrpt::poses::CPose3D firstPose(const Viewpoint& view, RobotKind kind)
{
	return {0, 0, kind == RobotKind::mav ? view.camera_height_m : 0.0, 0, view.body_pitch_rad, view.body_roll_rad};
}

/** A doorway is only partly known from where a jamb is out of the image. */
void markPartial(TruthFrame& frame, const std::string& id)
{
	for (TruthDoor& door : frame.doors)
	{
		const auto [least, most] = std::minmax(door.jamb_share[0], door.jamb_share[1]);
		if (door.id == id && door.visibility != Visibility::visible && least == 0 && most > 0)
			door.verdict = Verdict::partial;
	}
}

/** The scene of one try; without looks where it is none of its family. */
Scene tryScene(const SceneFamily& family, const SceneRequest& request, std::uint64_t seed)
{
	Sketch sketch(request.robot, request.intrinsics, seed);
	family.draw(sketch);
	Scene scene;
	if (!sketch.possible) return scene;
	layFloorAndCeiling(sketch);

	const Eigen::Vector2d place = sketch.robotPosition();
	const Eigen::Isometry3d map_from_building = WallFrame{place, sketch.view.yaw_rad}.pose(0, 0).inverse();
	move(sketch.world, map_from_building);
	for (const Eigen::Vector2d& corner :
	     rectangleOutline(sketch.robot_space.frame, sketch.robot_space.along, sketch.robot_space.behind))
		scene.room_in_map.emplace_back((map_from_building * Eigen::Vector3d(corner.x(), corner.y(), 0)).head<2>());
	scene.body_height_m = sketch.robot.height_m;
	if (!sketch.flies()) scene.body_height_m = std::max(scene.body_height_m, sketch.view.camera_height_m + 0.05);
	scene.world = std::make_unique<const World>(std::move(sketch.world));
	scene.rays = std::make_unique<RayScene>(*scene.world);

	const Looker looker{*scene.rays, request.robot, scene.body_height_m};
	const TruthCamera camera{request.intrinsics, mountOf(sketch.view, request.robot.kind)};
	const mrpt::poses::CPose3D first = firstPose(sketch.view, request.robot.kind);
	if (looker.touches(first) || !keeps(sketch.promise, {*scene.rays, camera, first, map_from_building})) return scene;
	for (const PlannedLook& look : planApproach(looker, sketch.promise, first, request.looks, mixed({seed, 1})))
	{
		SceneLook& taken = scene.looks.emplace_back();
		taken.t_s = look.t_s;
		taken.truth = truthAt(*scene.rays, camera, request.robot, look.map_from_robot);
		taken.truth.robot_from_camera = camera.robot_from_camera;
		if (!sketch.promise.one_jamb.empty()) markPartial(taken.truth, sketch.promise.one_jamb);
	}
	return scene;
}
}  // namespace

Scene makeScene(const SceneFamily& family, const SceneRequest& request)
{
	for (std::uint64_t attempt = 0; attempt < kTries; ++attempt)
	{
		Scene scene = tryScene(family, request,
		                       mixed({request.seed, hashOf(family.name), static_cast<std::uint64_t>(request.robot.kind),
		                              static_cast<std::uint64_t>(request.index), attempt}));
		scene.tries = static_cast<int>(attempt) + 1;
		if (!scene.looks.empty()) return scene;
	}
	throw std::logic_error(std::string("family ").append(family.name) + ": scene " + std::to_string(request.index) +
	                       " could not be drawn");
}
}  // namespace explore::simulation
