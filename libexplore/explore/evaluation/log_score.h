// The score of one log, scene by scene: what parts of an evaluation pass on to each other.
#pragma once

#include <explore/evaluation/frame_score.h>
#include <explore/evaluation/tally.h>

#include <string>
#include <vector>

namespace explore::evaluation
{
/** A frame worth looking at. */
struct WorstFrame
{
	std::size_t frame = 0;
	int scene = 0;
	double badness = 0;                ///< 4 a collision, 3 a false alarm, 2 a miss, ½ a bad heading
	std::string kind;                  ///< its first cause code, or "collision" or "heading"
	std::vector<std::string> remarks;  ///< one sentence a mistake
};

struct SceneScore
{
	int scene = 0;
	Tally tally;
};

/** What a log without truth still tells. */
struct ReportCounts
{
	Count frames = 0, report_frames = 0, reports = 0, positives = 0;
};

struct LogScore
{
	std::string log;  ///< path as given
	bool has_truth = false;
	std::string world, family, configuration, platform, noise;
	bool negative = false;
	ReportCounts reports;
	Count unmatched_frames = 0;           ///< depth frames that the truth does not know
	Count unread_frames = 0;              ///< frames of the truth without a depth frame
	std::string damage;                   ///< of the log; scored up to there
	std::string error;                    ///< why it could not be read at all
	std::vector<std::string> remarks;     ///< what its user should know
	std::vector<SceneScore> scenes;       ///< in the log's order
	std::vector<WorstFrame> worst;        ///< see worst_frames.h
	Count frame_rows = 0, door_rows = 0;  ///< lines of frames.csv and doors.csv
};

/** Adds a frame to its scene. */
void add(LogScore& log, const TruthFrame& truth, const FrameScore& score);

Json logJson(const LogScore& log);
/** What logJson() wrote. Throws InputError. */
LogScore logOf(const JsonPlace& place);
}  // namespace explore::evaluation
