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

void addScoreOptions(CLI::App& app, EvalOptions& options)
{
	app.add_option("LOG", options.logs, "Rawlogs; LOG.truth.json beside each is its truth")->type_name("");
	addIniOption(app, options);
	addOverrideOptions(app, options,
	                   "ground or mav: the ini's robot (that kind's usual one where the ini says the other) instead of "
	                   "the one of each log's truth");
	app.add_option("--jobs", options.jobs,
	               "Logs that are scored at the same time; the result is the same for any number")
	    ->type_name("N")
	    ->check(CLI::Range(1, 1024).description(""))
	    ->capture_default_str();
	app.add_option("--out", options.out,
	               "Folder for eval.json, frames.csv, doors.csv, table.txt, index.html and pictures/; else only the "
	               "tables are printed")
	    ->type_name("DIR");
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
	std::string require;
	CLI::App app("Scores explore-mrpt on logs with truth: doors, directions and headings.", "explore-eval");
	app.set_version_flag("--version", std::string("explore-eval ") + EXPLORE_VERSION);
	addScoreOptions(app, parsed.options);
	const CLI::Option* score_require = addRequire(app, require);
	const CLI::App* merge = addMergeCommand(app, parsed.options, require);
	app.footer(
	    "Exit codes: 0 done, 1 a requirement was missed (or internal error), 2 usage or configuration,\n"
	    "3 a log or part unreadable or damaged, 5 output cannot be written.");
	parsed.exit_code = parseArguments(app, argc, argv);
	if (parsed.exit_code) return parsed;
	if (score_require->count() > 0 || (merge->parsed() && merge->get_option("--require")->count() > 0))
		parsed.options.requirements = evaluation::parseRequirements(require);
	if (!merge->parsed()) checkLogs(parsed.options.logs);
	return parsed;
}
}  // namespace explore::app
