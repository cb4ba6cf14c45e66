// Whether a robot gets through a labelled opening now.
#pragma once

#include <explore/core/robot.h>
#include <explore/simulation/ray_scene.h>

namespace explore::simulation
{
/** Room [m] that a robot needs on every side of its body in an opening. */
inline constexpr double kPassingMargin_m = 0.05;
/** What a ground robot rolls over. */
inline constexpr double kStepHeight_m = 0.05;

struct Passage
{
	double clear_width_m = 0;  ///< what leaf, obstacles and those who stand in it now leave
	Verdict verdict = Verdict::open;
	bool passable = false;
};

/** The label's clear width less what moving bodies block now; where they leave a traversable opening too narrow, its
 *  verdict is `blocked`. Passable are `open`, `ajar` and `passage` openings whose clear width is at least the robot's
 *  diameter and kPassingMargin_m on both sides, and whose sill and lintel leave the same room: a ground robot rolls
 * over kStepHeight_m, a MAV needs a height within its flight band (above the label's floor). A MAV also passes above a
 * sill that makes the label's verdict `blocked`. */
Passage passageOf(const DoorLabel& label, const RayScene& scene, const RobotConfig& robot);
}  // namespace explore::simulation
