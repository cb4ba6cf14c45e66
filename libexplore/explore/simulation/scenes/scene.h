// One random scene: a labelled world in memory, and the places from which a robot looks at it.
#pragma once

#include <explore/core/truth.h>
#include <explore/simulation/ray_scene.h>
#include <explore/simulation/scenes/scene_families.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace explore::simulation
{
struct SceneRequest
{
	std::uint64_t seed = 0;
	int index = 0;  ///< the scene's number in its family
	RobotConfig robot;
	int looks = 1;  ///< of a short approach
	CameraIntrinsics intrinsics;
};

struct SceneLook
{
	double t_s = 0;    ///< since the first look
	TruthFrame truth;  ///< with map_from_robot and robot_from_camera; index, t and scene are the caller's
};

struct Scene
{
	std::unique_ptr<const World> world;  ///< the robot's first place is the map's origin on the floor plan, its yaw 0
	std::unique_ptr<RayScene> rays;
	double body_height_m = 0;  ///< of the robot, its camera's mast with it
	std::vector<SceneLook> looks;
	int tries = 0;  ///< until a drawing kept what its family promises
	/** Corners of the room or corridor in which the robot stands, on the floor plan. */
	std::vector<Eigen::Vector2d> room_in_map;
};

/** Scene `index` of a family. It depends on the family's name and on the request alone; more looks leave the first ones
 *  as they are. The first look shows what the family is about, and the robot touches nothing in any. Throws
 *  std::logic_error where no such scene was drawn in many tries. */
Scene makeScene(const SceneFamily& family, const SceneRequest& request);
}  // namespace explore::simulation
