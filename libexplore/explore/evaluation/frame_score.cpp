#include <explore/evaluation/frame_score.h>
#include <explore/evaluation/matching.h>

#include <algorithm>
#include <cmath>

namespace explore::evaluation
{
namespace
{
DoorCounts countsOf(const std::vector<DoorPair>& pairs)
{
	DoorCounts counts;
	for (const DoorPair& pair : pairs)
	{
		if (pair.outcome == Outcome::hit) ++counts.hits;
		if (pair.outcome == Outcome::miss) ++counts.misses;
		if (pair.outcome == Outcome::false_alarm) ++counts.false_alarms;
	}
	return counts;
}

/** Reports with a confidence, by whether a positive door is where they say; those at ignored doors are left out. */
void addCandidates(const FrameScore& score, const std::vector<TruthDoor>& truth, Tally& tally)
{
	std::vector<Report> asked = score.reports;
	for (Report& report : asked) report.positive = report.door.confidence.has_value();
	for (const DoorPair& pair : pairDoors(asked, truth, kCenterTolerances_m[kMainTolerance]))
		if (pair.report && (pair.outcome == Outcome::hit || pair.outcome == Outcome::false_alarm))
			tally.candidates.push_back(
			    {std::clamp(*asked[*pair.report].door.confidence, 0.0, 1.0), pair.outcome == Outcome::hit});
}

void scoreDoors(const ScoreInput& input, FrameScore& score)
{
	const auto& truth = input.truth_frame.doors;
	Tally& tally = score.tally;
	score.reports = reportsOf(input.result.percepts.doors, input.truth_frame.map_from_robot, input.config.robot);
	for (std::size_t i = 0; i < kCenterTolerances_m.size(); ++i)
	{
		auto pairs = pairDoors(score.reports, truth, kCenterTolerances_m[i]);
		tally.doors[i] = countsOf(pairs);
		if (i == kMainTolerance) score.pairs = std::move(pairs);
	}
	tally.report_frames = score.reports.empty() ? 0 : 1;
	tally.false_alarm_frames = tally.main().false_alarms > 0 ? 1 : 0;
	tally.confusion = confusionOf(score.reports, truth);
	addCandidates(score, truth, tally);
	for (const DoorPair& pair : score.pairs)
	{
		if (pair.outcome != Outcome::hit) continue;
		const Report& report = score.reports[*pair.report];
		tally.width_errors_m.push_back(rounded(widthError(report, truth[*pair.truth])));
		tally.center_errors_m.push_back(rounded(centerDistance(report, truth[*pair.truth])));
	}
}

void findCauses(const ScoreInput& input, FrameScore& score)
{
	const CauseInput causes{input.truth_frame,
	                        input.truth.intrinsics,
	                        mountOf(input.truth, input.truth_frame),
	                        input.result.percepts,
	                        input.config.perception,
	                        score.reports,
	                        score.pairs};
	for (const DoorPair& pair : score.pairs)
	{
		if (pair.outcome != Outcome::miss && pair.outcome != Outcome::false_alarm) continue;
		const Cause cause = causeOf(causes, pair);
		score.mistakes.push_back({pair, cause});
		auto& counts = pair.outcome == Outcome::miss ? score.tally.miss_causes : score.tally.false_alarm_causes;
		++counts[std::string(nameOf(cause))];
	}
}

/** The corridor's direction as the vanishing point with the most inliers has it, in the map; no value without one. */
std::optional<Eigen::Vector3d> reportedDirection(const ScoreInput& input)
{
	const auto& points = input.result.percepts.vanishing_points;
	const auto strongest = std::ranges::max_element(points, {}, &VanishingPoint::inliers);
	if (strongest == points.end()) return std::nullopt;
	Eigen::Vector3d direction = isometryOf(input.truth_frame.map_from_robot).linear() * strongest->direction;
	direction.z() = 0.0;
	return direction;
}

void scoreCorridor(const ScoreInput& input, FrameScore& score)
{
	const auto direction = reportedDirection(input);
	const TruthCorridor& corridor = input.truth_frame.corridor;
	if (corridor.state == CorridorState::none)
	{
		++score.tally.plain_frames;
		if (!direction) ++score.tally.plain_null;
	}
	if (corridor.state != CorridorState::corridor) return;
	++score.tally.corridor_frames;
	if (!direction) return;
	++score.tally.corridor_given;
	score.direction_error_rad = angleBetweenAxes(*direction, corridor.direction_in_map);
	score.tally.direction_errors_rad.push_back(rounded(*score.direction_error_rad));
}

void scoreDecision(const ScoreInput& input, FrameScore& score)
{
	if (!input.truth_frame.free_paths) return;
	const HeadingTruth truth{*input.truth_frame.free_paths, input.truth_frame.map_from_robot,
	                         mountOf(input.truth, input.truth_frame), input.truth.intrinsics};
	score.heading = scoreHeading(input.result.decision, truth, input.config.robot, input.config.heading);
	Tally& tally = score.tally;
	tally.heading_frames = 1;
	tally.good_headings = score.heading->good ? 1 : 0;
	tally.stops = score.heading->chosen ? 0 : 1;
	tally.good_stops = !score.heading->chosen && score.heading->good ? 1 : 0;
	tally.collisions = score.heading->collision ? 1 : 0;
}
}  // namespace

FrameScore scoreFrame(const ScoreInput& input)
{
	FrameScore score;
	score.tally.frames = 1;
	scoreDoors(input, score);
	findCauses(input, score);
	scoreCorridor(input, score);
	scoreDecision(input, score);
	return score;
}
}  // namespace explore::evaluation
