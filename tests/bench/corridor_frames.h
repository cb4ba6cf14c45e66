// The frames that the benchmarks run on: a Kinect's view of a corridor with doors, from many poses.
#pragma once

#include <explore/core/depth_frame.h>
#include "support/analytic_scene.h"

#include <vector>

namespace explore::test
{
/** A door of the corridor in the map frame [m]: the middle of the opening. */
struct CorridorDoor
{
	double x_m, y_m;
};

/** Width of each of the corridor's doors [m]. */
constexpr double kCorridorDoorWidth_m = 0.9;

/** All doors of the corridor that the frames show. */
std::vector<CorridorDoor> corridorDoors();

/** VGA frames along the corridor, straight ahead and turned to both sides; the camera is level, 0.6 m above the floor.
 *  With axial_scale = 1 and dropout_share = 0.02 they look like a Kinect's; noise {} gives clean ones. */
std::vector<DepthFrame> corridorFrames(const CameraNoise& noise);
}  // namespace explore::test
