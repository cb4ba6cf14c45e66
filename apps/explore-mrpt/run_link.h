// The link of one run to its robot: commands out, the robot's sensors in.
#pragma once

#include <explore-mrpt/console_logger.h>
#include <explore/sinks/robot_link/link_config.h>
#include <explore/sinks/robot_link/robot_link.h>
#include <explore/sinks/robot_link/robot_listener.h>
#include <explore/sources/source.h>

#include <memory>
#include <optional>

namespace explore::app
{
/** Does nothing where [robot_link] has none for both ends. */
class RunLink
{
public:
	/** Opens what the configuration, which check() has passed, asks for; from now on the robot is told to stop.
	 * `logger` outlives the link. Throws OutputError or InputError. */
	RunLink(const RobotLinkConfig& config, ConsoleLogger& logger);

	/** The source with what the robot says in its frames, which is the source itself where nobody listens. The link
	 *  outlives it. */
	std::unique_ptr<FrameSource> linked(std::unique_ptr<FrameSource> source);
	/** Whether commands go to a robot. */
	[[nodiscard]] bool commands() const { return m_commands.has_value(); }
	/** Commands what was decided about a frame, and logs what the link has to say. Throws OutputError when commands can
	 * no longer be delivered. */
	void decided(const Decision& decision, mrpt::Clock::time_point frame);
	/** Tells the robot to stop, for good, and logs what the link has to say. The destructor does the first as well. */
	void finish();

private:
	void say();

	ConsoleLogger& m_logger;
	LinkRemarks m_remarks;
	RobotInbox m_inbox;
	std::optional<RobotListener> m_listener;
	std::optional<RobotLink> m_commands;
};
}  // namespace explore::app
