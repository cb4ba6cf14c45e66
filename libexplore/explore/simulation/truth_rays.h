// What is truly in view of a camera, measured by noise-free rays in the labelled world.
#pragma once

#include <explore/core/robot.h>
#include <explore/core/truth.h>
#include <explore/simulation/ray_scene.h>

namespace explore::simulation
{
struct TruthCamera
{
	CameraIntrinsics intrinsics;
	mrpt::poses::CPose3D robot_from_camera;
};

/** Doors with their visibility (door_visibility.h, door_passage.h), corridor (corridor_truth.h), the obstacles of which
 *  a part is in view, moving bodies with them, and free paths (free_paths.h), for a robot at `map_from_robot`.
 *  `index`, `t` and `scene` are left for the caller. */
TruthFrame truthAt(const RayScene& scene, const TruthCamera& camera, const RobotConfig& robot,
                   const mrpt::poses::CPose3D& map_from_robot);
}  // namespace explore::simulation
