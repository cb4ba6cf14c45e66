// One frame's results against its truth: what is counted, the rows of the tables, and what went wrong.
#pragma once

#include <explore/evaluation/causes.h>
#include <explore/evaluation/heading_score.h>
#include <explore/pipeline/explorer.h>

#include <string>
#include <vector>

namespace explore::evaluation
{
struct ScoreInput
{
	const std::string& log;
	const DepthFrame& frame;
	const StepResult& result;
	const TruthLog& truth;
	const TruthFrame& truth_frame;
	const ExplorerConfig& config;
};

/** The camera's true place on the floor plane, map frame. */
Eigen::Vector2d cameraPlace(const ScoreInput& input);

/** An error of the frame. */
struct Mistake
{
	DoorPair pair;
	Cause cause{};
};

struct FrameScore
{
	Tally tally;
	std::vector<Report> reports;
	std::vector<DoorPair> pairs;  ///< at the main tolerance
	std::vector<Mistake> mistakes;
	std::optional<HeadingScore> heading;        ///< where the truth has free paths
	std::optional<double> direction_error_rad;  ///< where there is a corridor and a direction was given
};

FrameScore scoreFrame(const ScoreInput& input);

/** The head lines of frames.csv and doors.csv. */
std::string frameHeader();
std::string doorHeader();

/** The line of frames.csv. */
std::string frameRow(const ScoreInput& input, const FrameScore& score);
/** The same for a frame without truth. */
std::string frameRowWithoutTruth(const std::string& log, const DepthFrame& frame, const StepResult& result,
                                 const RobotConfig& robot);
/** The lines of doors.csv: one a pair. */
std::vector<std::string> doorRows(const ScoreInput& input, const FrameScore& score);
}  // namespace explore::evaluation
