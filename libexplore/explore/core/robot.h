// The robot's body and limits: what perception, choosing and avoiding all need to know about it.
#pragma once

#include <string_view>

namespace explore
{
enum class RobotKind
{
	ground,
	mav
};
[[nodiscard]] constexpr std::string_view nameOf(RobotKind kind)
{
	return kind == RobotKind::ground ? "ground" : "mav";
}

/** Defaults are the ground robot of doc/frames.md. */
struct RobotConfig
{
	RobotKind kind = RobotKind::ground;
	double radius_m = 0.22;
	double height_m = 0.60;  ///< ground: top of the body above the floor; MAV: height of the body itself
	double max_speed_mps = 0.5;
	double max_acceleration_mps2 = 0.5;
	double max_yaw_rate_radps = 1.0;
	double min_altitude_m = 0.5;  ///< MAV only: flight band of the body's centre above the floor
	double max_altitude_m = 2.0;
};
}  // namespace explore
