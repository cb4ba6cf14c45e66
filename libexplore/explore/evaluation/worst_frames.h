// Which frames are worth a picture: the worst, but few of a kind.
#pragma once

#include <explore/evaluation/log_score.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace explore::evaluation
{
/** What went wrong in a frame; no value where nothing did. */
std::optional<WorstFrame> badFrame(const ScoreInput& input, const FrameScore& score);

/** The frame `frame` of the log at place `log`. */
struct Selected
{
	std::size_t log = 0;
	WorstFrame frame;
};

/** The worst frames of all logs, the worst first: at most two of the same scenery (family, robot and noise) and kind,
 *  and 96 in all, for which each scenery gives its worst, then each its second worst, and so on. What is chosen among
 *  many logs is also chosen among any part of them that holds it. `logs` are in order of their paths. */
std::vector<Selected> selectWorst(const std::vector<LogScore>& logs);

/** Keeps what selectWorst() can ever choose of this log. */
void keepWorst(LogScore& log);

/** Name of a picture's file: tells log and frame, and differs for each. */
std::filesystem::path pictureName(const std::string& log, std::size_t frame);
}  // namespace explore::evaluation
