// explore-rawlog synth: logs of random labelled scenes, with their truth.
#pragma once

#include <functional>

namespace CLI
{
class App;
}

namespace explore::app
{
/** Adds the subcommand to `app`; when the command line names it, `command` is set to what it does. */
void addSynthCommand(CLI::App& app, std::function<int()>& command);
}  // namespace explore::app
