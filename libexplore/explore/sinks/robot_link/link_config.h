// [robot_link]: where velocity commands go, how often, and where the robot's own sensors come in.
#pragma once

#include <explore/config/fields.h>

#include <string>

namespace explore
{
struct RobotLinkConfig
{
	std::string commands = "none";  ///< none, stdout, udp://host:port or unix:///path
	double rate_hz = 20.0;          ///< of the commands
	double watchdog_s = 0.2;        ///< without a new decision for so long, the robot is told to stop
	std::string listen = "none";    ///< none, udp://host:port or unix:///path
};
/** [robot_link] */
void describe(FieldVisitor& fields, RobotLinkConfig& config);

/** Throws ConfigError, with key and value, for an address that is none. */
void check(const RobotLinkConfig& config);

/** Whether commands go to standard output. */
[[nodiscard]] bool usesStandardOutput(const RobotLinkConfig& config);
}  // namespace explore
