// Parses a command line the way every program of the project does.
#pragma once

#include <optional>

namespace CLI
{
class App;
}

namespace explore::app
{
/** The exit code after --help, --version or a usage error, which are answered here, or after no argument at all, which
 *  shows the help; no value when the program goes on. */
std::optional<int> parseArguments(CLI::App& app, int argc, const char* const* argv);
}  // namespace explore::app
