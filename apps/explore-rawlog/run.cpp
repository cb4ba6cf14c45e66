#include <common/parse_arguments.h>
#include <explore-rawlog/import_command.h>
#include <explore-rawlog/info_command.h>
#include <explore-rawlog/record_camera.h>
#include <explore-rawlog/run.h>
#ifdef EXPLORE_SIMULATION
#include <explore-rawlog/record_command.h>
#include <explore-rawlog/synth_command.h>
#endif

#include <CLI/CLI.hpp>
#include <functional>

namespace explore::app
{
int runRawlogTool(int argc, const char* const* argv)
{
#ifdef EXPLORE_SIMULATION
	const std::string description =
	    "Makes rawlogs from recordings, depth cameras and simulated worlds, and tells what they contain.";
#else
	const std::string description = "Makes rawlogs from recordings and depth cameras, and tells what they contain.";
#endif
	CLI::App app(description, "explore-rawlog");
	app.set_version_flag("--version", std::string("explore-rawlog ") + EXPLORE_VERSION);
	app.require_subcommand(1);
	app.footer(
	    "Exit codes: 0 done, 1 internal error, 2 usage, 3 input unreadable or damaged,\n"
	    "4 camera lost, 5 output cannot be written, 130 / 143 recording of a camera interrupted.");
	std::function<int()> command;
	addImportCommand(app, command);
	addInfoCommand(app, command);
#ifdef EXPLORE_SIMULATION
	addRecordCommand(app, command);
	addSynthCommand(app, command);
#else
	addCameraRecordCommand(app, command);
#endif
	const FirstCommands first{
	    "  explore-rawlog info MY.rawlog                      what is in a recording, and whether it is damaged\n"
	    "  explore-rawlog record --openni2 --out MY.rawlog    records the depth camera that is plugged in\n"
	    "  explore-rawlog import --png DIR --intrinsics 525,525,319.5,239.5 --out MY.rawlog\n"
	    "                                                     a rawlog of 16-bit depth images\n"};
	if (const auto exit_code = parseArguments(app, first, argc, argv)) return *exit_code;
	return command();
}
}  // namespace explore::app
