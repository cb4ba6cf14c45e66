// Sensor poses from a rawlog-grabber configuration file, as rawlog-edit --sensors-pose takes it.
#pragma once

#include <mrpt/poses/CPose3D.h>

#include <filesystem>
#include <map>
#include <string>

namespace explore
{
/** robot_from_sensor by sensor label. */
using SensorPoses = std::map<std::string, mrpt::poses::CPose3D>;

/** Reads pose_x/y/z [m] and pose_yaw/pitch/roll [deg] of every section that has a sensorLabel (or else under the
 *  section's own name). Other keys of a grabber file are left alone; a section without any pose key is not a pose.
 *  Throws ConfigError for a missing file, a number that is none, or no pose at all. */
SensorPoses loadSensorPoses(const std::filesystem::path& path);
}  // namespace explore
