#include <common/interrupt.h>
#include <common/linked_source.h>
#include <explore-mrpt/run_link.h>
#include <explore/sinks/robot_link/json_command_sink.h>

namespace explore::app
{
RunLink::RunLink(const RobotLinkConfig& config, ConsoleLogger& logger) : m_logger(logger), m_inbox(m_remarks)
{
	const LinkAddress commands = linkAddress("commands", config.commands);
	const LinkAddress listen = linkAddress("listen", config.listen);
	if (listen.kind != LinkKind::none) m_listener.emplace(listen, m_inbox);
	if (commands.kind == LinkKind::none) return;
	const RobotLinkTiming timing{config.rate_hz, config.watchdog_s};
	// The robot is not kept waiting for the frame that is being worked on.
	m_commands.emplace(makeCommandSink(commands, m_remarks), timing, m_remarks,
	                   [this] { return m_inbox.alarms().any() || signalReceived() != 0; });
}

std::unique_ptr<FrameSource> RunLink::linked(std::unique_ptr<FrameSource> source)
{
	if (!m_listener) return source;
	return std::make_unique<LinkedSource>(std::move(source), m_inbox, m_logger);
}

void RunLink::decided(const Decision& decision, mrpt::Clock::time_point frame)
{
	say();
	if (m_commands) m_commands->decided(decision, mrpt::Clock::toDouble(frame));
}

void RunLink::finish()
{
	if (m_commands) m_commands->stop();
	say();
	if (const std::size_t count = m_inbox.malformed(); count > 1)
		m_logger.logStr(mrpt::system::LVL_WARN, "robot link: " + std::to_string(count) + " messages were malformed");
}

void RunLink::say()
{
	for (const std::string& remark : m_remarks.take()) m_logger.logStr(mrpt::system::LVL_WARN, remark);
}
}  // namespace explore::app
