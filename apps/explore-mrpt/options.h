// The command line of explore-mrpt.
#pragma once

#include <common/config_choices.h>
#include <mrpt/system/COutputLogger.h>

#include <optional>
#include <string>
#include <vector>

namespace explore::app
{
struct Options : ConfigChoices
{
	std::string out = "explore-out";  ///< "-" = JSON lines on standard output and no files
	std::optional<mrpt::system::VerbosityLevel> verbosity;
	std::optional<std::size_t> max_frames;
	bool realtime = false;  ///< no faster than the frames were, or are, taken
	bool quiet = false;
	bool dump_config = false;
	std::string resume;  ///< folder of the run to go on with; empty = a new run

	[[nodiscard]] bool toStandardOutput() const { return out == "-"; }
};

/** What the command line asks for; after --help, --version or a usage error, which it answers itself, the exit code. */
struct ParsedOptions
{
	Options options;
	std::optional<int> exit_code;
};
ParsedOptions parseOptions(int argc, const char* const* argv);

/** The program's version, as in --version and summary.json. */
std::string version();
}  // namespace explore::app
