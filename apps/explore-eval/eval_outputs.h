// The folder that explore-eval leaves, and reads when parts are merged.
#pragma once

#include <explore/evaluation/eval_file.h>
#include <explore/evaluation/worst_frames.h>

#include <filesystem>
#include <string>
#include <vector>

namespace explore::app
{
struct EvalPaths
{
	explicit EvalPaths(const std::filesystem::path& folder);
	std::filesystem::path eval, frames, doors, table, page, pictures;
};

/** Makes the folder ready, the results of an earlier run removed. Throws OutputError. */
EvalPaths prepareEvalFolder(const std::filesystem::path& folder);

/** Lines of frames.csv and doors.csv, by the places of the logs. */
struct EvalRows
{
	std::vector<std::string> frames, doors;
};

/** The rows of a part's CSV files, as many a log as its score says. Throws InputError where the files do not fit. */
EvalRows readRows(const EvalPaths& part, const std::vector<evaluation::LogScore>& logs);

/** An evaluation with its results. */
struct Evaluated
{
	const evaluation::Evaluation& evaluation;
	const evaluation::Results& results;
	const EvalRows& rows;
	std::string tables;
};

/** Writes everything but the pictures, which are there already. eval.json comes last, so that a folder with one is
 *  complete. Throws OutputError. */
void writeEvaluated(const EvalPaths& paths, const Evaluated& evaluated, const std::vector<evaluation::Selected>& worst);
}  // namespace explore::app
