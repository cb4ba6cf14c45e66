// Where a simulated camera sits on its robot.
#pragma once

#include <explore/core/robot.h>
#include <explore/sources/source_config.h>
#include <mrpt/poses/CPose3D.h>

namespace explore::app
{
/** robot_from_camera as [camera] gives it, else the usual mount of a robot of this kind. */
mrpt::poses::CPose3D simulatedMount(const CameraConfig& camera, RobotKind kind);
}  // namespace explore::app
