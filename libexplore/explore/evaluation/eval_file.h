// eval.json: the scores of all logs, scene by scene, so that parts can be joined exactly; and the results over them.
#pragma once

#include <explore/evaluation/figures.h>

#include <filesystem>
#include <string>
#include <vector>

namespace explore::evaluation
{
/** How an evaluation was run; parts are joined only where all of it agrees. */
struct EvalSetup
{
	std::string version;
	std::string ini;               ///< as given; empty: built-in defaults
	std::string robot;             ///< of --robot; empty: that of each log's truth
	std::vector<std::string> set;  ///< --set and --seed
	std::string config;            ///< the complete ini in force

	bool operator==(const EvalSetup&) const = default;
};

struct Evaluation
{
	EvalSetup setup;
	std::vector<LogScore> logs;  ///< in order of their paths
};

/** The document; the same evaluation gives the same bytes. */
std::string evalText(const Evaluation& evaluation, const Results& results);
/** Setup and logs of an eval.json; its results are not read, they follow from the logs. Throws InputError. */
Evaluation readEval(const std::filesystem::path& path);

/** Throws InputError where a log is there twice; `logs` are in order of their paths. */
void checkOrder(const std::vector<LogScore>& logs);
}  // namespace explore::evaluation
