// index.html: the tables and the worst frames, in one file that needs no other.
#pragma once

#include <explore/evaluation/eval_file.h>
#include <explore/evaluation/worst_frames.h>

#include <string>
#include <vector>

namespace explore::evaluation
{
/** A selected frame with its picture. */
struct PagePicture
{
	Selected selected;
	std::string jpeg;  ///< the file's bytes
};

/** What the page shows above the pictures. */
struct PageTables
{
	std::string text;
	std::vector<ReliabilityBin> reliability;  ///< drawn as a diagram; empty where the method gives no confidences
};

/** `pictures`, the worst first, are shown as long as the page stays below 15 MB. */
std::string pageText(const Evaluation& evaluation, const PageTables& tables, const std::vector<PagePicture>& pictures);
}  // namespace explore::evaluation
