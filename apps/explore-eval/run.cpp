#include <common/exit_codes.h>
#include <explore-eval/compare_command.h>
#include <explore-eval/eval_outputs.h>
#include <explore-eval/gallery.h>
#include <explore-eval/log_input.h>
#include <explore-eval/merge_parts.h>
#include <explore-eval/process_pool.h>
#include <explore-eval/run.h>
#include <explore-eval/score_log.h>
#include <explore-eval/soak_command.h>
#include <explore/evaluation/results_text.h>
#include <explore/sinks/output_file.h>

#include <algorithm>
#include <iostream>

namespace explore::app
{
namespace
{
using namespace evaluation;

EvalSetup setupOf(const EvalOptions& options, AppConfig config)
{
	config.source.rawlog.clear();
	EvalSetup setup{EXPLORE_VERSION, options.ini, "", options.overrides(), dumpConfig(config)};
	if (options.robot) setup.robot = nameOf(*options.robot);
	return setup;
}

std::function<void(std::size_t)> progressOf(const EvalOptions& options, const char* what)
{
	return [&options, what, count = std::size_t{0}](std::size_t task) mutable
	{
		++count;
		if (!options.quiet)
			std::cerr << what << " " << count << " of " << options.logs.size() << ": " << options.logs[task] << '\n';
	};
}

/** All logs of the command line, in their order. */
struct Scored
{
	std::vector<LogScore> logs;
	EvalRows rows;
};
Scored scoreLogs(const EvalOptions& options, const LoadedConfig& loaded)
{
	const auto texts = inProcesses(
	    options.logs, options.jobs, [&](std::size_t i) { return textOf(scoreLog(options.logs[i], loaded, options)); },
	    progressOf(options, "scored"));
	Scored scored;
	for (const std::string& text : texts)
	{
		ScoredLog log = scoredLogOf(text);
		if (!options.pictures) log.score.worst.clear();
		scored.logs.push_back(std::move(log.score));
		scored.rows.frames.push_back(std::move(log.frame_rows));
		scored.rows.doors.push_back(std::move(log.door_rows));
	}
	return scored;
}

void drawWorst(const EvalOptions& options, const LoadedConfig& loaded, const std::vector<Selected>& worst,
               const std::filesystem::path& folder)
{
	if (worst.empty()) return;
	std::filesystem::create_directories(folder);
	std::vector<FrameScenes> frames(options.logs.size());
	for (const Selected& selected : worst) frames[selected.log][selected.frame.frame] = selected.frame.scene;
	inProcesses(
	    options.logs, options.jobs,
	    [&](std::size_t i)
	    {
		    drawFrames(options.logs[i], frames[i], folder, loaded, options);
		    return std::string();
	    },
	    [](std::size_t) {});
}

/** Tables and requirements for people; the exit code for scripts. */
int conclude(const Evaluation& evaluation, const Results& results, const std::string& tables,
             const EvalOptions& options)
{
	OutputFile::standardOutput().write(tables);
	const bool damaged = std::ranges::any_of(
	    evaluation.logs, [](const LogScore& log) { return !log.error.empty() || !log.damage.empty(); });
	const auto missed = missedRequirements(options.requirements, results);
	for (const std::string& line : missed) std::cerr << "explore-eval: requirement missed: " << line << '\n';
	for (const LogScore& log : evaluation.logs)
	{
		if (!log.error.empty()) std::cerr << "explore-eval: " << log.log << ": not scored: " << log.error << '\n';
		if (!log.damage.empty()) std::cerr << "explore-eval: " << log.log << ": damaged: " << log.damage << '\n';
	}
	if (damaged) return kInputError;
	return missed.empty() ? kDone : kRequirementMissed;
}

int evaluate(const EvalOptions& options)
{
	const LoadedConfig loaded = loadScoredConfig(options);
	if (!options.out.empty()) prepareEvalFolder(options.out);
	Scored scored = scoreLogs(options, loaded);
	const Evaluation evaluation{setupOf(options, loaded.config), std::move(scored.logs)};
	const Results results = resultsOf(evaluation.logs);
	const std::string tables = resultsText(evaluation.logs, results);
	if (!options.out.empty())
	{
		const EvalPaths paths(options.out);
		const auto worst = selectWorst(evaluation.logs);
		drawWorst(options, loaded, worst, paths.pictures);
		writeEvaluated(paths, {evaluation, results, scored.rows, tables}, worst);
	}
	return conclude(evaluation, results, tables, options);
}

int merge(const EvalOptions& options)
{
	const MergedParts merged = mergeParts(options.parts);
	const Results results = resultsOf(merged.evaluation.logs);
	const std::string tables = resultsText(merged.evaluation.logs, results);
	const auto worst = selectWorst(merged.evaluation.logs);
	const EvalPaths paths = prepareEvalFolder(options.out);
	copyPictures(merged, worst, paths.pictures);
	writeEvaluated(paths, {merged.evaluation, results, merged.rows, tables}, worst);
	return conclude(merged.evaluation, results, tables, options);
}
}  // namespace

int runEval(const EvalOptions& options)
{
	switch (options.command)
	{
		case EvalCommand::score:
			return evaluate(options);
		case EvalCommand::merge:
			return merge(options);
		case EvalCommand::compare:
			return compareEvaluations(options);
		case EvalCommand::gallery:
			return makeGallery(options);
		case EvalCommand::soak:
			return soak(options);
	}
	return kInternalError;
}
}  // namespace explore::app
