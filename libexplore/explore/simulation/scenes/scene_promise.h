// Whether a look shows what its scene's family is about.
#pragma once

#include <explore/simulation/scenes/scene_sketch.h>
#include <explore/simulation/truth_rays.h>

namespace explore::simulation
{
struct PromisedLook
{
	const RayScene& scene;
	const TruthCamera& camera;
	const mrpt::poses::CPose3D& map_from_robot;
	const Eigen::Isometry3d& map_from_building;  ///< regions are of the building
};

bool keeps(const Promise& promise, const PromisedLook& look);
}  // namespace explore::simulation
