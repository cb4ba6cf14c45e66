// Two runs over the same logs, scene by scene: what another configuration changes, with paired intervals.
#pragma once

#include <explore/evaluation/eval_file.h>
#include <explore/evaluation/scene_bootstrap.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace explore::evaluation
{
/** An evaluation by the name that tables give it. */
struct NamedRun
{
	std::string name;
	Evaluation evaluation;
};

/** A figure that runs are compared by. */
struct ComparedFigure
{
	std::string_view name;   ///< precision, recall, …
	std::string_view title;  ///< for tables
	bool large = true;       ///< better the larger it is
};
/** All of them, in the order of the tables. */
std::vector<ComparedFigure> comparedFigures();

/** Differences are other − base, all shares of 1. */
struct Difference
{
	std::optional<double> base, other;
	std::optional<double> difference;  ///< no value where one of both has no case
	std::optional<Interval> interval;  ///< 95 %, by resamples of the scenes that both share
};

/** What differs in one group of scenes; places as in comparedFigures(). */
struct GroupComparison
{
	std::string family, platform, noise;
	std::vector<Difference> figures;
};

struct RunComparison
{
	std::string run;         ///< name of the other run
	std::size_t scenes = 0;  ///< that both have
	Count unpaired = 0;      ///< scenes that one of both lacks
	std::vector<Difference> figures;
	std::vector<GroupComparison> families;
};

/** Pairs logs by their path (by their file name where that is enough to tell each run's logs apart) and scenes by
 *  their number. Logs without truth and those of mirrors are left out. Throws InputError where no scene is in both. */
RunComparison compareRuns(const NamedRun& base, const NamedRun& other);
}  // namespace explore::evaluation
