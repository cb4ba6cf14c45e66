// Scores one log, and draws its worst frames.
#pragma once

#include <explore-eval/log_input.h>
#include <explore/evaluation/log_score.h>

#include <filesystem>
#include <map>
#include <string>

namespace explore::app
{
/** A log's score with its lines of frames.csv and doors.csv. */
struct ScoredLog
{
	evaluation::LogScore score;
	std::string frame_rows, door_rows;
};

/** A log that cannot be read at all comes back with its error. Throws what is not the log's fault. */
ScoredLog scoreLog(const std::string& log, const LoadedConfig& loaded, const EvalOptions& options);

/** Frames of a log by their number, with the scene of each. */
using FrameScenes = std::map<std::size_t, int>;

/** Draws these frames into `folder`, under pictureName(). Throws OutputError. */
void drawFrames(const std::string& log, const FrameScenes& frames, const std::filesystem::path& folder,
                const LoadedConfig& loaded, const EvalOptions& options);

/** For the way from one process to another. */
std::string textOf(const ScoredLog& scored);
ScoredLog scoredLogOf(const std::string& text);
}  // namespace explore::app
