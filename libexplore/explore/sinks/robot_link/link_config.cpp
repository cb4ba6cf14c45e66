#include <explore/core/errors.h>
#include <explore/sinks/robot_link/link_address.h>
#include <explore/sinks/robot_link/link_config.h>

namespace explore
{
void describe(FieldVisitor& fields, RobotLinkConfig& config)
{
	fields.section("robot_link", "Velocity commands to the robot, and its own sensors; formats in doc/robot-link.md");
	fields.text("commands", config.commands,
	            "Where commands go, one line of JSON each: none, stdout, udp://host:port or unix:///path of a stream "
	            "socket on which the robot listens");
	fields.real("rate", config.rate_hz, {1.0, 1000.0}, "Hz", "Commands are sent so often, whatever the camera's rate");
	fields.real("watchdog", config.watchdog_s, {0.02, 10.0}, "s",
	            "Without a new decision for so long the robot is told to stop; more than the time between two frames");
	fields.text("listen", config.listen,
	            "Where the robot's poses, accelerations, bumpers, cliff sensors and scans come in: none, "
	            "udp://address:port (0.0.0.0 = every network) or unix:///path of a socket that is made there");
}

void check(const RobotLinkConfig& config)
{
	linkAddress("commands", config.commands);
	if (linkAddress("listen", config.listen).kind == LinkKind::standard_output)
		throw ConfigError(
		    "[robot_link] listen = stdout: nothing comes in there; accepted: none, udp://address:port or unix:///path");
}

bool usesStandardOutput(const RobotLinkConfig& config)
{
	return linkAddress("commands", config.commands).kind == LinkKind::standard_output;
}
}  // namespace explore
