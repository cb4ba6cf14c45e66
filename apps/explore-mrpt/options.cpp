#include <common/parse_arguments.h>
#include <explore-mrpt/options.h>

#include <CLI/CLI.hpp>
#include <map>
#include <set>

namespace explore::app
{
namespace
{
using mrpt::system::VerbosityLevel;

const std::map<std::string, VerbosityLevel> kVerbosities{{"DEBUG", mrpt::system::LVL_DEBUG},
                                                         {"INFO", mrpt::system::LVL_INFO},
                                                         {"WARN", mrpt::system::LVL_WARN},
                                                         {"ERROR", mrpt::system::LVL_ERROR}};

void addInputOptions(CLI::App& app, Options& options)
{
	addIniOption(app, options);
	auto* rawlog =
	    app.add_option("--rawlog", options.rawlog, "Recording to explore, instead of the ini's")->type_name("FILE");
	auto* oni =
	    app.add_option("--oni", options.oni, "Recording that OpenNI2 made, to explore instead of the ini's input")
	        ->type_name("FILE")
	        ->excludes(rawlog);
	app.add_option("--world", options.world, "Gazebo world to explore with a simulated robot, instead of the ini's")
	    ->type_name("FILE")
	    ->excludes(rawlog)
	    ->excludes(oni);
	addOverrideOptions(app, options, "ground or mav; where the ini says the other, with that one's default size");
	app.add_option("--max-frames", options.max_frames, "Stops after N frames")
	    ->type_name("N")
	    ->check(CLI::PositiveNumber.description(""));
	app.add_flag("--realtime", options.realtime, "Keeps the camera's pace; else as fast as it goes");
}

void addOutputOptions(CLI::App& app, Options& options)
{
	app.add_option("--out", options.out, "Folder for the results; - writes JSON lines to standard output, and no files")
	    ->type_name("DIR")
	    ->capture_default_str();
	app.add_option("--verbosity", options.verbosity, "DEBUG, INFO (default), WARN or ERROR")
	    ->type_name("LEVEL")
	    ->transform(CLI::CheckedTransformer(kVerbosities, CLI::ignore_case).description(""));
	app.add_flag("--quiet", options.quiet, "No progress, no summary; warnings and errors only");
	app.add_option("--resume", options.resume,
	               "Goes on with the run in this folder that was killed or interrupted, as it was begun")
	    ->type_name("DIR");
	app.add_flag("--dump-config", options.dump_config, "Prints the complete ini with the values in force, and exits");
}

/** A run that goes on has its configuration: nothing that would change it may be given with --resume. */
void excludeFromResume(CLI::App& app)
{
	const std::set<std::string> allowed{"--help",      "--version",    "--resume",  "--quiet",
	                                    "--verbosity", "--max-frames", "--realtime"};
	CLI::Option* const resume = app.get_option("--resume");
	for (CLI::Option* const option : app.get_options())
		if (!allowed.contains(option->get_name())) resume->excludes(option);
}
}  // namespace

ParsedOptions parseOptions(int argc, const char* const* argv)
{
	ParsedOptions parsed;
	CLI::App app(
	    "Turns depth frames into headings: doors, vanishing points, obstacles avoided. The frames are those of a "
	    "recording, of an OpenNI2 camera, or of a simulated robot that goes where the headings lead.",
	    "explore-mrpt");
	app.set_version_flag("--version", "explore-mrpt " + version());
	addInputOptions(app, parsed.options);
	addOutputOptions(app, parsed.options);
	excludeFromResume(app);
	app.footer(
	    "Exit codes: 0 done, 1 internal error, 2 usage or configuration, 3 input unreadable or damaged,\n"
	    "4 sensor lost, 5 output cannot be written, 130 / 143 interrupted.");
	const FirstCommands first{
	    "  explore-mrpt --ini corridor.ini                    a simulated robot explores our corridor world\n"
	    "  explore-mrpt --ini xtion.ini                       the depth camera that is plugged in (OpenNI2)\n"
	    "  explore-mrpt --ini corridor.ini --rawlog MY.rawlog a recording of yours\n"
	    "\nThen open explore-out/report.html in a browser.\n"};
	parsed.exit_code = parseArguments(app, first, argc, argv);
	return parsed;
}

std::string version()
{
	return EXPLORE_VERSION;
}
}  // namespace explore::app
