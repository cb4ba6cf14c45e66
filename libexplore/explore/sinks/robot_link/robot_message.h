// What the robot tells the explorer, one JSON object a message: its pose, accelerations, bumper, cliff sensor, scan.
#pragma once

#include <mrpt/core/Clock.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/poses/CPose3D.h>

#include <Eigen/Core>
#include <optional>
#include <string_view>

namespace explore
{
/** The parts that were in the message; at least one. */
struct RobotMessage
{
	template <class Value>
	struct Timed
	{
		mrpt::Clock::time_point time;  ///< as sent, else when it came
		Value value;
	};
	std::optional<Timed<mrpt::poses::CPose3D>> map_from_robot;
	std::optional<Timed<Eigen::Vector3d>> acceleration_mps2;  ///< robot frame; at rest it points up
	std::optional<Timed<bool>> bumper_pressed, cliff_seen;
	std::optional<Timed<mrpt::obs::CObservation2DRangeScan>> scan;
};

/** `text` is a JSON object as doc/robot-link.md describes it. No value for anything else: no JSON, unknown or missing
 *  names, numbers out of range. */
std::optional<RobotMessage> parseRobotMessage(std::string_view text, mrpt::Clock::time_point received);
}  // namespace explore
