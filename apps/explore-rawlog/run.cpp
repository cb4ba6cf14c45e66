#include <explore-mrpt/exit_codes.h>
#include <explore-rawlog/import_command.h>
#include <explore-rawlog/info_command.h>
#include <explore-rawlog/run.h>
#ifdef EXPLORE_SIMULATION
#include <explore-rawlog/record_command.h>
#include <explore-rawlog/synth_command.h>
#endif

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>

namespace explore::app
{
int runRawlogTool(int argc, const char* const* argv)
{
	CLI::App app("Makes rawlogs from recordings and simulated worlds, and tells what they contain.", "explore-rawlog");
	app.set_version_flag("--version", std::string("explore-rawlog ") + EXPLORE_VERSION);
	app.require_subcommand(1);
	app.footer(
	    "Exit codes: 0 done, 1 internal error, 2 usage, 3 input unreadable or damaged, 5 output cannot be written.");
	std::function<int()> command;
	addImportCommand(app, command);
	addInfoCommand(app, command);
#ifdef EXPLORE_SIMULATION
	addRecordCommand(app, command);
	addSynthCommand(app, command);
#endif
	try
	{
		app.parse(argc, argv);
	}
	catch (const CLI::ParseError& answer)
	{
		return app.exit(answer, std::cout, std::cerr) == 0 ? kDone : kUsageError;
	}
	return command();
}
}  // namespace explore::app
