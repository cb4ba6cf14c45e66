// Whatever takes velocity commands: a socket, standard output, a robot that MRPT's navigators drive.
#pragma once

#include <explore/core/results.h>

#include <optional>

namespace explore
{
/** A command and the time of the frame that it answers. */
struct TimedCommand
{
	std::optional<double> t_s;  ///< seconds since 1970 (UTC); no value before the first frame
	Command command;            ///< robot frame
};

/** Used by one thread at a time. Its methods throw OutputError when commands can no longer be delivered. */
class CommandSink
{
public:
	CommandSink() = default;
	CommandSink(const CommandSink&) = delete;
	CommandSink& operator=(const CommandSink&) = delete;
	virtual ~CommandSink() = default;

	/** The robot is to move so until the next call. */
	virtual void send(const TimedCommand& command) = 0;
	/** The robot is to stand still; `t_s` as in TimedCommand. */
	virtual void stop(std::optional<double> t_s) = 0;
};
}  // namespace explore
