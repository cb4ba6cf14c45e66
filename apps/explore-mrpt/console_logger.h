// Log messages of the library and the program, and the progress, on standard error.
#pragma once

#include <explore-mrpt/options.h>
#include <explore/sinks/progress.h>
#include <mrpt/system/COutputLogger.h>

namespace explore::app
{
/** An MRPT logger whose messages go to standard error and keep clear of the progress line. */
class ConsoleLogger : public mrpt::system::COutputLogger
{
public:
	explicit ConsoleLogger(const Options& options);

	[[nodiscard]] StatusLine& status() { return m_status; }

private:
	StatusLine m_status;
};
}  // namespace explore::app
