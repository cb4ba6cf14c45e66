// Joins the folders of evaluations over parts of the logs.
#pragma once

#include <explore-eval/eval_outputs.h>

#include <filesystem>
#include <string>
#include <vector>

namespace explore::app
{
struct MergedParts
{
	evaluation::Evaluation evaluation;
	EvalRows rows;
	std::vector<std::filesystem::path> pictures;  ///< the folder of each log's pictures
};

/** Throws InputError for a folder that is no complete evaluation, for parts that were made with different
 *  configurations, and for a log that two parts hold. */
MergedParts mergeParts(const std::vector<std::string>& parts);

/** Throws InputError or OutputError. */
void copyPictures(const MergedParts& merged, const std::vector<evaluation::Selected>& worst,
                  const std::filesystem::path& folder);
}  // namespace explore::app
