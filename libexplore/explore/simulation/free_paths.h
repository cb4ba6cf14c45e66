// How far a robot's body can be moved in each direction before it touches anything: d_true(θ).
#pragma once

#include <explore/core/truth.h>
#include <explore/simulation/ray_scene.h>

namespace explore::simulation
{
/** The body of `robot` (see robot_body.h) swept from `map_from_robot` along 360 azimuths, counted from the robot's yaw,
 *  and for a MAV along the elevations −30° … 30° by 10°. Lengths are those of the path that the body's centre takes, to
 *  a tenth of a millimetre; 0 where the body touches something already. Panes of glass block; what moves stands still.
 */
TruthFreePaths freePaths(const RayScene& scene, const RobotConfig& robot, const mrpt::poses::CPose3D& map_from_robot);
}  // namespace explore::simulation
