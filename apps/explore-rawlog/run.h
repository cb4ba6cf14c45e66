// The command line of explore-rawlog.
#pragma once

namespace explore::app
{
/** Parses the arguments and runs the subcommand that they name; returns the exit code. Throws the library's errors. */
int runRawlogTool(int argc, const char* const* argv);
}  // namespace explore::app
