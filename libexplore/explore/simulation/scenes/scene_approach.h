// A short approach to what a scene is about: the places of the looks after the first.
#pragma once

#include <explore/simulation/ray_scene.h>
#include <explore/simulation/scenes/scene_sketch.h>
#include <mrpt/poses/CPose3D.h>

#include <cstdint>
#include <vector>

namespace explore::simulation
{
/** The robot's body in the scene. */
struct Looker
{
	const RayScene& scene;
	const RobotConfig& robot;
	double body_height_m;

	[[nodiscard]] bool touches(const mrpt::poses::CPose3D& map_from_robot, double margin_m = 0.02) const;
};

struct PlannedLook
{
	double t_s = 0;
	mrpt::poses::CPose3D map_from_robot;
};

/** `looks` places from `first` on, 0.2–0.5 s apart: forward by 6–25 cm each while the way is free, turning toward the
 *  first promised door (or on, where there is none); on the spot by at least 3° where it is not. Nothing is touched.
 *  Fewer looks are the same first ones. */
std::vector<PlannedLook> planApproach(const Looker& looker, const Promise& promise, const mrpt::poses::CPose3D& first,
                                      int looks, std::uint64_t seed);
}  // namespace explore::simulation
