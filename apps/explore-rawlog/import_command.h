// explore-rawlog import: a folder of depth images becomes a rawlog.
#pragma once

#include <functional>

namespace CLI
{
class App;
}

namespace explore::app
{
/** Adds the subcommand to `app`; when the command line names it, `command` is set to what it does. */
void addImportCommand(CLI::App& app, std::function<int()>& command);
}  // namespace explore::app
