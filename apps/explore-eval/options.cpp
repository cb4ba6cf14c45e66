#include <common/parse_arguments.h>
#include <explore-eval/options.h>
#include <explore/core/errors.h>

#include <CLI/CLI.hpp>
#include <algorithm>

namespace explore::app
{
namespace
{
/** --require, which both commands have. */
CLI::Option* addRequire(CLI::App& app, std::string& require)
{
	return app
	    .add_option(
	        "--require", require,
	        "Figures to reach, else exit code 1: NAME=NUMBER,... with names of " + evaluation::requirementNames())
	    ->type_name("LIST");
}

void addJobsOption(CLI::App& app, EvalOptions& options, const std::string& help)
{
	app.add_option("--jobs", options.jobs, help)
	    ->type_name("N")
	    ->check(CLI::Range(1, 1024).description(""))
	    ->capture_default_str();
}

void addScoreOptions(CLI::App& app, EvalOptions& options)
{
	app.add_option("LOG", options.logs, "Rawlogs; LOG.truth.json beside each is its truth")->type_name("");
	addIniOption(app, options);
	addOverrideOptions(app, options,
	                   "ground or mav: the ini's robot (that kind's usual one where the ini says the other) instead of "
	                   "the one of each log's truth");
	addJobsOption(app, options, "Logs that are scored at the same time; the result is the same for any number");
	app.add_option("--out", options.out,
	               "Folder for eval.json, frames.csv, doors.csv, table.txt, index.html and pictures/; else only the "
	               "tables are printed")
	    ->type_name("DIR");
	app.add_flag_callback(
	    "--no-pictures", [&options] { options.pictures = false; },
	    "No pictures of the worst frames, for which the logs are read a second time");
	app.add_flag("--quiet", options.quiet, "No progress");
}

CLI::App* addMergeCommand(CLI::App& app, EvalOptions& options, std::string& require)
{
	CLI::App* merge = app.add_subcommand("merge",
	                                     "Joins the --out folders of runs over parts of the logs: the result "
	                                     "is that of one run over all of them");
	merge->add_option("PART", options.parts, "Folders")->required()->type_name("");
	merge->add_option("--out", options.out, "Folder for the joined results")->required()->type_name("DIR");
	addRequire(*merge, require);
	return merge;
}

void addCompareCommand(CLI::App& app, EvalOptions& options, std::string& cost)
{
	CLI::App* compare = app.add_subcommand("compare",
	                                       "What other configurations change: --out folders of runs over the same "
	                                       "scenes, paired scene by scene, or of soak, paired run by run");
	compare->add_option("BASE", options.base, "Folder of the run that the others are compared with")
	    ->required()
	    ->type_name("");
	compare->add_option("OTHER", options.others, "Folders of the other runs")->required()->type_name("");
	compare->add_option("--out", options.out, "Folder for compare.txt and, of scenes, compare.json; else only printed")
	    ->type_name("DIR");
	compare
	    ->add_option("--cost", cost,
	                 "Points that a figure may get worse, else exit code 1: NAME=POINTS,... with names of " +
	                     evaluation::costLimitNames())
	    ->type_name("LIST");
}

void addGalleryCommand(CLI::App& app, EvalOptions& options)
{
	CLI::App* gallery = app.add_subcommand("gallery",
	                                       "A page in Markdown with a picture of the first frame of each log: what is "
	                                       "there, what was found and why");
	gallery->add_option("LOG", options.logs, "Rawlogs with their truth beside them")->required()->type_name("");
	addIniOption(*gallery, options);
	addOverrideOptions(*gallery, options, "ground or mav: the ini's robot instead of the one of each log's truth");
	gallery->add_option("--out", options.out, "Folder for scene-pictures.md and images/scenes/")
	    ->required()
	    ->type_name("DIR");
}

void addSoakCommand(CLI::App& app, EvalOptions& options)
{
	CLI::App* soak = app.add_subcommand("soak", "Explores simulated worlds again and again and tells how it went");
	addIniOption(*soak, options);
	soak->add_option("--world", options.worlds,
	                 "World to explore, with @ and a start where it needs one (as [simulator] start): repeatable")
	    ->required()
	    ->type_name("FILE[@START]")
	    ->allow_extra_args(false);
	addOverrideOptions(*soak, options, "ground or mav; where the ini says the other, with that one's default size");
	soak->add_option("--runs", options.runs, "Runs in each world, with seeds from --seed (else 1) on")
	    ->type_name("N")
	    ->check(CLI::Range(1, 1000000).description(""))
	    ->capture_default_str();
	soak->add_option("--minutes", options.minutes, "No run begins later than that")
	    ->type_name("M")
	    ->check(CLI::PositiveNumber.description(""));
	addJobsOption(*soak, options, "Runs at the same time; the result is the same for any number");
	soak->add_option("--out", options.out, "Folder for soak.csv, soak.txt and WORLD/SEED/ with the files of each run")
	    ->required()
	    ->type_name("DIR");
	soak->add_flag("--keep-frames", options.keep_frames, "Keeps frames.jsonl and timing.csv of each run");
	soak->add_flag("--quiet", options.quiet, "No progress");
}

EvalCommand commandOf(const CLI::App& app)
{
	if (app.got_subcommand("merge")) return EvalCommand::merge;
	if (app.got_subcommand("compare")) return EvalCommand::compare;
	if (app.got_subcommand("soak")) return EvalCommand::soak;
	return app.got_subcommand("gallery") ? EvalCommand::gallery : EvalCommand::score;
}

void checkLogs(std::vector<std::string>& logs)
{
	if (logs.empty()) throw ConfigError("no log was named; give one or more rawlogs, or the command merge");
	std::ranges::sort(logs);
	if (const auto twice = std::ranges::adjacent_find(logs); twice != logs.end())
		throw ConfigError(*twice + ": named twice; each log may be given once");
}
}  // namespace

ParsedEvalOptions parseEvalOptions(int argc, const char* const* argv)
{
	ParsedEvalOptions parsed;
	std::string require, cost;
	CLI::App app("Scores explore-mrpt on logs with truth: doors, directions and headings.", "explore-eval");
	app.set_version_flag("--version", std::string("explore-eval ") + EXPLORE_VERSION);
	addScoreOptions(app, parsed.options);
	const CLI::Option* score_require = addRequire(app, require);
	const CLI::App* merge = addMergeCommand(app, parsed.options, require);
	addCompareCommand(app, parsed.options, cost);
	addGalleryCommand(app, parsed.options);
	addSoakCommand(app, parsed.options);
	app.footer(
	    "Frames are judged one by one: memory.enabled is false, whatever the ini says, unless --set names it.\n"
	    "Exit codes: 0 done, 1 a requirement was missed or a cost exceeded (or internal error), 2 usage or "
	    "configuration,\n"
	    "3 a log or part unreadable or damaged or a soak's run failed, 5 output cannot be written.");
	const FirstCommands first{
	    "  explore-eval MY.rawlog --ini corridor.ini --out scores   scores a log that MY.truth.json tells the truth "
	    "of\n"
	    "  explore-eval compare scores other-scores                 what another configuration changed, with "
	    "intervals\n"
	    "  explore-eval soak --ini corridor.ini --world corridor.sdf --out runs\n"
	    "                                                           explores a simulated world ten times\n"};
	parsed.exit_code = parseArguments(app, first, argc, argv);
	if (parsed.exit_code) return parsed;
	if (score_require->count() > 0 || (merge->parsed() && merge->get_option("--require")->count() > 0))
		parsed.options.requirements = evaluation::parseRequirements(require);
	if (!cost.empty()) parsed.options.costs = evaluation::parseCostLimits(cost);
	const EvalCommand command = parsed.options.command = commandOf(app);
	if (command == EvalCommand::score || command == EvalCommand::gallery) checkLogs(parsed.options.logs);
	return parsed;
}
}  // namespace explore::app
