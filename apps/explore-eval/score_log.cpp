#include <explore-eval/score_log.h>
#include <explore/core/errors.h>
#include <explore/evaluation/truth_file.h>
#include <explore/evaluation/worst_frames.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace explore::app
{
namespace
{
using namespace evaluation;

bool sameBody(const RobotConfig& a, const RobotConfig& b)
{
	return a.kind == b.kind && a.radius_m == b.radius_m && a.height_m == b.height_m;
}

void describeLog(const LogInput& input, LogScore& score)
{
	const auto& truth = input.truth();
	score.has_truth = truth.has_value();
	if (!truth)
	{
		score.remarks.push_back("no truth: " + truthPathOf(score.log).string() +
		                        " is not there; its reports are counted, nothing is scored");
		return;
	}
	score.world = truth->world;
	score.family = truth->family;
	score.configuration = truth->configuration;
	score.negative = truth->negative;
	score.platform = nameOf(truth->robot.kind);
	score.noise = truth->noise;
	if (!sameBody(input.config().robot, truth->robot))
		score.remarks.emplace_back(
		    "the robot is not the one whose truth this is: what fits through is judged for both");
}

void countReports(const ReplayedFrame& replayed, const RobotConfig& robot, ReportCounts& counts)
{
	const auto reports = reportsOf(replayed.result.percepts.doors, replayed.frame.map_from_robot, robot);
	++counts.frames;
	counts.report_frames += reports.empty() ? 0 : 1;
	counts.reports += reports.size();
	counts.positives += static_cast<Count>(std::ranges::count_if(reports, &Report::positive));
}

/** Takes up one frame. */
void scoreReplayed(const LogInput& input, const ReplayedFrame& replayed, ScoredLog& scored)
{
	LogScore& score = scored.score;
	const ExplorerConfig& config = input.config();
	countReports(replayed, config.robot, score.reports);
	++score.frame_rows;
	if (replayed.truth == nullptr)
	{
		if (score.has_truth) ++score.unmatched_frames;
		scored.frame_rows += frameRowWithoutTruth(score.log, replayed.frame, replayed.result, config.robot);
		return;
	}
	const ScoreInput frame{score.log, replayed.frame, replayed.result, *input.truth(), *replayed.truth, config};
	const FrameScore frame_score = scoreFrame(frame);
	add(score, *replayed.truth, frame_score);
	scored.frame_rows += frameRow(frame, frame_score);
	for (const std::string& row : doorRows(frame, frame_score))
	{
		++score.door_rows;
		scored.door_rows += row;
	}
	if (auto bad = badFrame(frame, frame_score)) score.worst.push_back(std::move(*bad));
}

void finish(const LogInput& input, LogScore& score)
{
	const SourceReport report = input.report();
	score.damage = report.damage;
	for (const std::string& message : input.messages()) score.remarks.push_back(message);
	if (score.reports.frames == 0 && score.damage.empty()) score.error = "holds no depth frame";
	if (!input.truth()) return;
	const Count scored = score.reports.frames - score.unmatched_frames;
	score.unread_frames = input.truth()->frames.size() - std::min<Count>(scored, input.truth()->frames.size());
	if (score.unmatched_frames > 0)
		score.remarks.push_back(std::to_string(score.unmatched_frames) + " depth frames have no truth; not scored");
	if (score.unread_frames > 0)
		score.remarks.push_back(std::to_string(score.unread_frames) +
		                        " frames of the truth have no depth frame; not scored");
	keepWorst(score);
}
}  // namespace

ScoredLog scoreLog(const std::string& log, const LoadedConfig& loaded, const EvalOptions& options)
{
	ScoredLog scored;
	scored.score.log = log;
	try
	{
		LogInput input(log, loaded, options);
		describeLog(input, scored.score);
		input.replay([](int) { return true; },
		             [&](const ReplayedFrame& replayed)
		             {
			             scoreReplayed(input, replayed, scored);
			             return true;
		             });
		finish(input, scored.score);
	}
	catch (const InputError& error)
	{
		scored = {};
		scored.score.log = log;
		scored.score.error = error.what();
	}
	return scored;
}

std::string textOf(const ScoredLog& scored)
{
	return jsonText(
	    {{"score", logJson(scored.score)}, {"frame_rows", scored.frame_rows}, {"door_rows", scored.door_rows}});
}

ScoredLog scoredLogOf(const std::string& text)
{
	const Json document = Json::parse(text);
	const JsonPlace place(document, "score of a log");
	return {logOf(place.at("score")), place.at("frame_rows").text(), place.at("door_rows").text()};
}
}  // namespace explore::app
