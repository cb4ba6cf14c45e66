#include <explore/core/geometry.h>
#include <explore/core/matching.h>
#include <explore/evaluation/frame_score.h>

#include <algorithm>
#include <cmath>

namespace explore::evaluation
{
namespace
{
constexpr double kCloseDirection_rad = 2.0 * kDegree_rad;

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
void addCandidates(const FrameScore& score, const std::vector<TruthDoor>& truth, const DoorRule& neither_way,
                   Tally& tally)
{
	std::vector<Report> asked = score.reports;
	for (Report& report : asked) report.positive = report.door.confidence.has_value();
	for (const DoorPair& pair : pairDoors(asked, truth, kCenterTolerances_m[kMainTolerance], neither_way))
		if (pair.report && (pair.outcome == Outcome::hit || pair.outcome == Outcome::false_alarm))
			tally.candidates.push_back(
			    {std::clamp(*asked[*pair.report].door.confidence, 0.0, 1.0), pair.outcome == Outcome::hit});
}

void addHit(const Report& report, const TruthDoor& door, const Eigen::Vector2d& camera, Tally& tally)
{
	const CenterError error = centerError(report, door);
	tally.width_errors_m.push_back(rounded(widthError(report, door)));
	tally.center_errors_m.push_back(rounded(centerDistance(report, door)));
	tally.along_errors_m.push_back(rounded(error.along_m));
	tally.across_errors_m.push_back(rounded(error.across_m));
	tally.hit_distances_m.push_back(rounded((door.center_in_map.head<2>() - camera).norm()));
}

/** Hits and misses one by one. */
void scorePairs(const ScoreInput& input, FrameScore& score)
{
	const Eigen::Vector2d camera = cameraPlace(input);
	for (const DoorPair& pair : score.pairs)
	{
		if (pair.outcome != Outcome::hit && pair.outcome != Outcome::miss) continue;
		const TruthDoor& door = input.truth_frame.doors[*pair.truth];
		const bool hit = pair.outcome == Outcome::hit, narrow = door.width_m < kNarrowDoor_m;
		if (narrow) ++(hit ? score.tally.narrow_hits : score.tally.narrow_misses);
		if (hit) addHit(score.reports[*pair.report], door, camera, score.tally);
	}
}

/** The frame as one of many: whether anything was reported, or wrongly reported. */
void scoreAlarms(const ScoreInput& input, const DoorRule& neither_way, FrameScore& score)
{
	const auto& truth = input.truth_frame.doors;
	const Eigen::Vector2d camera = cameraPlace(input);
	Tally& tally = score.tally;
	if (std::ranges::any_of(truth, [&](const TruthDoor& door)
	                        { return isFarDrop(door, camera) && door.visibility != Visibility::hidden; }))
	{
		tally.unscored_frames = 1;
		return;
	}
	tally.report_frames = score.reports.empty() ? 0 : 1;
	tally.false_alarm_frames = tally.main().false_alarms > 0 ? 1 : 0;
	tally.open_reports = openWhereNothing(score.reports, truth, score.pairs, neither_way);
	tally.open_frames = tally.open_reports > 0 ? 1 : 0;
}

void scoreDoors(const ScoreInput& input, FrameScore& score)
{
	const auto& truth = input.truth_frame.doors;
	const Eigen::Vector2d camera = cameraPlace(input);
	const DoorRule neither_way = [&](const TruthDoor& door)
	{ return countsNeitherWay(door) || isFarDrop(door, camera); };
	Tally& tally = score.tally;
	score.reports = reportsOf(input.result.percepts.doors, input.truth_frame.map_from_robot, input.config.robot);
	for (std::size_t i = 0; i < kCenterTolerances_m.size(); ++i)
	{
		auto pairs = pairDoors(score.reports, truth, kCenterTolerances_m[i], neither_way);
		tally.doors[i] = countsOf(pairs);
		if (i == kMainTolerance) score.pairs = std::move(pairs);
	}
	scoreAlarms(input, neither_way, score);
	scorePairs(input, score);
	tally.confusion = confusionOf(score.reports, truth, neither_way);
	addCandidates(score, truth, neither_way, tally);
}

void findCauses(const ScoreInput& input, FrameScore& score)
{
	const CauseInput causes{input.truth_frame,
	                        input.truth.intrinsics,
	                        mountOf(input.truth, input.truth_frame),
	                        input.result.percepts,
	                        input.config.perception,
	                        input.config.robot,
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
	if (*score.direction_error_rad <= kCloseDirection_rad) ++score.tally.corridor_close;
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

Eigen::Vector2d cameraPlace(const ScoreInput& input)
{
	const mrpt::poses::CPose3D map_from_camera =
	    input.truth_frame.map_from_robot + mountOf(input.truth, input.truth_frame);
	return {map_from_camera.x(), map_from_camera.y()};
}

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
