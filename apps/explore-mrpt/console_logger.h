// Log messages of the library and the program, and the progress, on standard error; warnings are kept for the summary.
#pragma once

#include <explore-mrpt/options.h>
#include <explore/sinks/progress.h>
#include <mrpt/system/COutputLogger.h>

#include <string>
#include <utility>
#include <vector>

namespace explore::app
{
/** An MRPT logger whose messages go to standard error and keep clear of the progress line. */
class ConsoleLogger : public mrpt::system::COutputLogger
{
public:
	explicit ConsoleLogger(const Options& options);

	[[nodiscard]] StatusLine& status() { return m_status; }
	/** All warnings so far in their order, shown or not. */
	[[nodiscard]] const std::vector<std::string>& warnings() const { return m_warnings; }
	/** Those of the part of the run that went before, in place of what was said again on the way back to it. */
	void takeWarnings(std::vector<std::string> warnings) { m_warnings = std::move(warnings); }

private:
	void take(std::string_view message, mrpt::system::VerbosityLevel level);

	StatusLine m_status;
	mrpt::system::VerbosityLevel m_shown;  ///< this and all above
	std::vector<std::string> m_warnings;
};
}  // namespace explore::app
