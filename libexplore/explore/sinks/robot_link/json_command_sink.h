// Commands as lines of JSON to standard output, over UDP or to a Unix stream socket.
#pragma once

#include <explore/sinks/robot_link/command_sink.h>
#include <explore/sinks/robot_link/link_address.h>
#include <explore/sinks/robot_link/link_remarks.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace explore
{
/** The line of a command, ended by a newline; format in doc/robot-link.md. Throws std::logic_error when a number in it
 *  is not finite. */
std::string commandLine(const TimedCommand& command, bool stop, std::uint64_t seq);

/** Numbers the commands and hands each line to `write`. */
class JsonCommandSink : public CommandSink
{
public:
	using Write = std::function<void(const std::string& line)>;
	explicit JsonCommandSink(Write write);

	void send(const TimedCommand& command) override;
	void stop(std::optional<double> t_s) override;

private:
	Write m_write;
	std::uint64_t m_next = 0;  ///< number of the next command
};

/** A sink that sends to `address`, which is not none; `remarks` outlives it.
 *  - udp: a datagram a command; a receiver that is not there, or a network that is down, is remarked once and no error
 *  - unix_stream, stdout: a line a command; a receiver that is gone, or reads nothing for a second, is an OutputError
 *  Throws OutputError where the receiver of a stream is not there, or the host is unknown. */
std::unique_ptr<CommandSink> makeCommandSink(const LinkAddress& address, LinkRemarks& remarks);
}  // namespace explore
