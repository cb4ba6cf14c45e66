// explore-rawlog info: what a rawlog or a simulated world contains, and whether it is intact.
#pragma once

#include <functional>

namespace CLI
{
class App;
}

namespace explore::app
{
/** Adds the subcommand to `app`; when the command line names it, `command` is set to what it does. */
void addInfoCommand(CLI::App& app, std::function<int()>& command);
}  // namespace explore::app
