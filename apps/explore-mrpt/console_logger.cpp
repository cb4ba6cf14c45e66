#include <explore-mrpt/console_logger.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace explore::app
{
namespace
{
StatusLine::Style styleFor(const Options& options)
{
	if (options.quiet) return StatusLine::Style::silent;
	return ::isatty(STDERR_FILENO) != 0 ? StatusLine::Style::terminal : StatusLine::Style::plain;
}

mrpt::system::VerbosityLevel levelFor(const Options& options)
{
	return options.verbosity.value_or(options.quiet ? mrpt::system::LVL_WARN : mrpt::system::LVL_INFO);
}

std::string_view nameOf(mrpt::system::VerbosityLevel level)
{
	switch (level)
	{
		case mrpt::system::LVL_DEBUG:
			return "debug: ";
		case mrpt::system::LVL_WARN:
			return "warning: ";
		case mrpt::system::LVL_ERROR:
			return "error: ";
		default:
			return "";
	}
}

std::string_view withoutLineEnd(std::string_view text)
{
	while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
	return text;
}
}  // namespace

ConsoleLogger::ConsoleLogger(const Options& options)
    : COutputLogger("explore-mrpt"),
      m_status(styleFor(options), [](std::string_view text) { std::cerr << text; }),
      m_shown(levelFor(options))
{
	logging_enable_console_output = false;
	setMinLoggingLevel(std::min(m_shown, mrpt::system::LVL_WARN));
	logRegisterCallback([this](std::string_view message, mrpt::system::VerbosityLevel level,
	                           std::string_view /*logger*/, mrpt::Clock::time_point /*time*/)
	                    { take(withoutLineEnd(message), level); });
}

void ConsoleLogger::take(std::string_view message, mrpt::system::VerbosityLevel level)
{
	if (level == mrpt::system::LVL_WARN) m_warnings.emplace_back(message);
	if (level >= m_shown) m_status.log(std::string(nameOf(level)).append(message));
}
}  // namespace explore::app
