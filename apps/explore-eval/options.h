// The command line of explore-eval.
#pragma once

#include <common/config_choices.h>
#include <explore/evaluation/requirements.h>

#include <optional>
#include <string>
#include <vector>

namespace explore::app
{
struct EvalOptions : ConfigChoices
{
	std::vector<std::string> logs;   ///< to score
	std::vector<std::string> parts;  ///< to merge instead: folders of earlier runs
	int jobs = 1;
	std::string out;  ///< empty = nothing is written
	std::vector<evaluation::Requirement> requirements;
	bool quiet = false;

	[[nodiscard]] bool merges() const { return !parts.empty(); }
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
