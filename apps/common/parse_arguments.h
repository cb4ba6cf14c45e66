// Parses a command line the way every program of the project does.
#pragma once

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace explore::app
{
/** What to try first: a few lines "command   what it does", indented. */
struct FirstCommands
{
	std::string lines;
};

/** The exit code after --help, --version or a usage error, which are answered here, or after no argument at all, which
 *  is answered with `first`; no value when the program goes on. --help ends with `first` and the app's footer. */
std::optional<int> parseArguments(CLI::App& app, const FirstCommands& first, int argc, const char* const* argv);
}  // namespace explore::app
