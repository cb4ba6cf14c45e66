#include <common/exit_codes.h>
#include <explore-eval/compare_command.h>
#include <explore-eval/eval_outputs.h>
#include <explore/core/errors.h>
#include <explore/evaluation/compare_runs.h>
#include <explore/evaluation/soak_pairs.h>
#include <explore/sinks/output_file.h>
#include <explore/sinks/output_folder.h>

#include <algorithm>
#include <iostream>

namespace explore::app
{
namespace
{
namespace fs = std::filesystem;
using namespace evaluation;

NamedRun readRun(const std::string& folder)
{
	const std::string name = fs::path(folder).lexically_normal().filename().string();
	return {name.empty() || name == "." ? folder : name, readEval(EvalPaths(folder).eval)};
}

/** The folder's name, and what its --set has that the base's has not. */
std::string nameBeside(const NamedRun& base, const NamedRun& run)
{
	std::string name = run.name;
	for (const std::string& item : run.evaluation.setup.set)
		if (std::ranges::find(base.evaluation.setup.set, item) == base.evaluation.setup.set.end())
			name.append(" ").append(item);
	return name;
}

/** To the standard output, and with --out into its folder. */
void show(const std::string& tables, const EvalOptions& options)
{
	if (!options.out.empty())
	{
		makeFolder(options.out);
		writeFileAtomically(fs::path(options.out) / "compare.txt", tables);
	}
	OutputFile::standardOutput().write(tables);
}

/** Explorations of `soak`, run by run. */
int compareSoaks(const std::vector<SoakRun>& base, const EvalOptions& options)
{
	if (!options.costs.empty()) throw ConfigError("--cost is about evaluations, not about the explorations of soak");
	std::string tables;
	for (const std::string& folder : options.others)
	{
		const std::vector<SoakPairs> pairs = pairsOf(base, readSoakRuns(folder));
		if (pairs.empty()) throw InputError(folder + ": no exploration of the worlds and seeds of " + options.base);
		tables += soakPairsText(options.base, folder, pairs);
	}
	show(tables, options);
	return kDone;
}
}  // namespace

int compareEvaluations(const EvalOptions& options)
{
	if (const std::vector<SoakRun> runs = readSoakRuns(options.base); !runs.empty()) return compareSoaks(runs, options);
	const NamedRun base = readRun(options.base);
	std::vector<RunComparison> comparisons;
	for (const std::string& folder : options.others)
	{
		NamedRun other = readRun(folder);
		other.name = nameBeside(base, other);
		comparisons.push_back(compareRuns(base, other));
	}
	const std::string tables = comparisonText(base.name, comparisons);
	show(tables, options);
	if (!options.out.empty())
		writeFileAtomically(fs::path(options.out) / "compare.json", comparisonJson(base.name, comparisons));
	const auto exceeded = exceededLimits(options.costs, comparisons);
	for (const std::string& line : exceeded) std::cerr << "explore-eval: costs too much: " << line << '\n';
	return exceeded.empty() ? kDone : kRequirementMissed;
}
}  // namespace explore::app
