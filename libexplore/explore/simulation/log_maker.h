// Turns what a simulated robot senses into the observations of a rawlog.
#pragma once

#include <explore/core/truth.h>
#include <explore/simulation/depth_camera.h>
#include <mrpt/obs/CObservation.h>

#include <vector>

namespace explore::simulation
{
/** The farthest depth that the observations hold. */
inline constexpr double kFarthestDepth_m = 65.535;

/** Depth (16 bit, 1 mm) and, where there is one, colour as MRPT has them; deterministic bytes. Viewers scale their
 *  colours by `max_range_m`, the camera's. */
mrpt::obs::CObservation::Ptr depthObservation(const CameraShot& shot, const mrpt::poses::CPose3D& robot_from_camera,
                                              mrpt::Clock::time_point time, const std::string& sensor_label,
                                              double max_range_m = kFarthestDepth_m);
/** The robot's own idea of its pose (CObservationRobotPose). */
mrpt::obs::CObservation::Ptr poseObservation(const mrpt::poses::CPose3D& map_from_robot, mrpt::Clock::time_point time,
                                             const std::string& sensor_label);
/** The same from wheels: x, y and yaw (CObservationOdometry). */
mrpt::obs::CObservation::Ptr odometryObservation(const mrpt::poses::CPose3D& map_from_robot,
                                                 mrpt::Clock::time_point time, const std::string& sensor_label);
/** Specific force and turning rate in the robot frame. */
mrpt::obs::CObservation::Ptr imuObservation(const Eigen::Vector3d& acceleration_mps2, const Eigen::Vector3d& rate_radps,
                                            mrpt::Clock::time_point time, const std::string& sensor_label);
}  // namespace explore::simulation
