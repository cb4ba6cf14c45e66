// explore-rawlog record: a drive or flight through a simulated world becomes a rawlog with its truth.
#pragma once

#include <functional>

namespace CLI
{
class App;
}

namespace explore::app
{
/** Adds the subcommand to `app`; when the command line names it, `command` is set to what it does. */
void addRecordCommand(CLI::App& app, std::function<int()>& command);
}  // namespace explore::app
