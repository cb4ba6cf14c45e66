// The command line of explore-eval.
#pragma once

#include <common/config_choices.h>
#include <explore/evaluation/compare_text.h>
#include <explore/evaluation/requirements.h>

#include <optional>
#include <string>
#include <vector>

namespace explore::app
{
enum class EvalCommand
{
	score,
	merge,
	compare,
	gallery,
	soak,
};

struct EvalOptions : ConfigChoices
{
	EvalCommand command = EvalCommand::score;
	std::vector<std::string> logs;    ///< to score, or to show
	std::vector<std::string> parts;   ///< to merge: folders of earlier runs
	std::string base;                 ///< to compare: folder of a run
	std::vector<std::string> others;  ///< with it: folders of runs
	std::vector<evaluation::CostLimit> costs;
	std::vector<std::string> worlds;  ///< to explore: "FILE" or "FILE@START"
	int runs = 10;                    ///< of each world
	double minutes = 0;               ///< no run begins later; 0 = all run
	bool keep_frames = false;         ///< frames.jsonl and timing.csv of every run
	int jobs = 1;
	std::string out;  ///< empty = nothing is written
	std::vector<evaluation::Requirement> requirements;
	bool quiet = false;
	bool pictures = true;  ///< of the worst frames
};

/** What the command line asks for; after --help, --version or a usage error, which it answers itself, the exit code. */
struct ParsedEvalOptions
{
	EvalOptions options;
	std::optional<int> exit_code;
};
/** Throws ConfigError for a requirement that cannot be. */
ParsedEvalOptions parseEvalOptions(int argc, const char* const* argv);
}  // namespace explore::app
