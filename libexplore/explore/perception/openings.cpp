#include <explore/perception/far_jamb.h>
#include <explore/perception/openings.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kProfileMargin_m = 2.0;  // of a wall beyond its samples: a door between its end and the corner

/** The heights between which things in a doorway are in the robot's way. */
BodyBand bodyBand(const RobotConfig& robot, const OpeningsConfig& config)
{
	if (robot.kind == RobotKind::ground)
		return {config.rays.floor_m, std::max(robot.height_m, config.measure.standing_top_m)};
	return {std::max(config.rays.floor_m, robot.min_altitude_m - 0.5 * robot.height_m), config.measure.standing_top_m};
}

/** The wall beside an opening, from `from_m` on, as far as it is seen to go on. */
WallPiece pieceBeside(const WallProfile& profile, double from_m, JambSide side)
{
	const auto strips = static_cast<int>(profile.strips.size());
	const int step = side == JambSide::right ? 1 : -1;
	WallPiece piece;
	int i = static_cast<int>(std::floor((from_m - profile.first_m) / profile.strip_m)) + step;
	for (; i >= 0 && i < strips; i += step)
	{
		const WallStrip& strip = profile.strips[static_cast<std::size_t>(i)];
		// What is not seen, or hidden, may be wall as well.
		piece.ends = strip.all > 0 && 2 * (strip.of(RayMet::through) + strip.of(RayMet::shallow)) > strip.all;
		if (piece.ends) break;
		if (2 * strip.of(RayMet::wall) > strip.all)
			piece.length_m += profile.strip_m;
		else if (strip.all > 0)
			piece.hidden = true;
	}
	return piece;
}

/** How much further out a jamb is than it seems. Where rays lead outward they end on the jamb's face, and as long as
 *  that is within the tolerance behind the wall they count as wall. */
double hiddenBySurface(const RayJudge& judge, const Jamb& jamb, JambSide side)
{
	const double outward_m = side == JambSide::right ? jamb.along_m : -jamb.along_m;
	if (outward_m <= 0.0 || jamb.kind != JambKind::wall) return 0.0;
	const double range_m = std::hypot(outward_m, judge.distance_m());
	const double tolerance_m =
	    judge.tolerance_m() + judge.noiseOf(static_cast<float>(range_m)) * judge.distance_m() / range_m;
	return tolerance_m * outward_m / judge.distance_m();
}

/** At least one jamb stands, and the other may. */
bool isBounded(const OpeningFrame& frame)
{
	const auto has = [&](JambKind kind) { return frame.left.kind == kind || frame.right.kind == kind; };
	return has(JambKind::wall) && !has(JambKind::nothing);
}

/** How far two openings, seen from above, are one and the same. */
bool overlap(const Opening& a, const Opening& b)
{
	const double near_m = 0.5 * std::max(0.6, std::min(a.frame.width_m(), b.frame.width_m()));
	return (a.center - b.center).norm() < near_m + 0.1;
}

int rankOf(Verdict verdict)
{
	switch (verdict)
	{
		case Verdict::open:
		case Verdict::passage:
		case Verdict::ajar:
			return 0;
		case Verdict::blocked:
		case Verdict::drop:
		case Verdict::closed:
			return 1;
		default:
			return 2;
	}
}

bool better(const Opening& a, const Opening& b)
{
	if (rankOf(a.verdict.verdict) != rankOf(b.verdict.verdict))
		return rankOf(a.verdict.verdict) < rankOf(b.verdict.verdict);
	const auto worth = [](const Opening& opening)
	{ return opening.verdict.confidence + 0.1 * std::min(opening.frame.left.support, opening.frame.right.support); };
	return worth(a) > worth(b);
}

/** Of openings that overlap the better one stays. */
std::vector<Opening> distinct(std::vector<Opening> openings)
{
	std::ranges::stable_sort(openings, better);
	std::vector<Opening> kept;
	for (Opening& opening : openings)
		if (std::ranges::none_of(kept, [&](const Opening& other) { return overlap(opening, other); }))
			kept.push_back(std::move(opening));
	return kept;
}
}  // namespace

void describe(FieldVisitor& fields, OpeningsConfig& config)
{
	describe(fields, config.rays);
	describe(fields, config.measure);
	describe(fields, config.verdict);
}

std::vector<Opening> findOpenings(const LevelView& view, const std::vector<UprightWall>& walls,
                                  const RobotConfig& robot, const OpeningsConfig& config,
                                  const SensorNoiseConfig& noise)
{
	const double free_depth_m =
	    config.measure.depth_behind ? 2.0 * robot.radius_m + config.measure.length_margin_m : 0.0;
	const BodyBand body = bodyBand(robot, config);
	std::vector<Opening> openings;
	for (std::size_t i = 0; i < walls.size(); ++i)
	{
		const UprightWall& wall = walls[i];
		const RayJudge judge(view, wall, free_depth_m, config.rays, noise);
		const WallProfile profile = wallProfile(judge, view, wall, kProfileMargin_m, config.rays);
		for (const Stretch& stretch :
		     candidateStretches(profile, config.verdict.min_report_m - profile.strip_m, config.measure.max_width_m))
		{
			Opening opening;
			opening.frame = {fitJamb(judge, stretch.from_m, JambSide::left, config.rays, config.jambs),
			                 fitJamb(judge, stretch.to_m, JambSide::right, config.rays, config.jambs)};
			if (opening.frame.width_m() < config.verdict.min_report_m || !isBounded(opening.frame)) continue;
			if (config.jambs.full_resolution)
			{
				opening.frame.left.along_m -= hiddenBySurface(judge, opening.frame.left, JambSide::left);
				opening.frame.right.along_m += hiddenBySurface(judge, opening.frame.right, JambSide::right);
			}
			if (std::max(wall.at(opening.frame.left.along_m).norm(), wall.at(opening.frame.right.along_m).norm()) >
			    config.verdict.max_range_m)
				continue;
			if (config.jambs.full_resolution) opening.frame = withFarJambFromFace(judge, opening.frame, body);
			opening.measure = measureOpening(judge, view, wall, opening.frame, body, free_depth_m, config.measure);
			opening.context = {2.0 * robot.radius_m + config.verdict.width_margin_m,
			                   pieceBeside(profile, opening.frame.left.along_m, JambSide::left),
			                   pieceBeside(profile, opening.frame.right.along_m, JambSide::right),

			                   wall.to_m - wall.from_m, wall.samples};
			if (!config.verdict.leaf) opening.measure.clear_width_m = opening.frame.width_m();
			const auto verdict = judgeOpening(opening.frame, opening.measure, opening.context, config.verdict);
			if (!verdict) continue;
			opening.verdict = *verdict;
			opening.wall = i;
			opening.center = wall.at(opening.frame.middle_m());
			opening.normal = wall.normal;
			openings.push_back(opening);
		}
	}
	return distinct(std::move(openings));
}

Opening openingOf(const CorridorEnd& end, const RobotConfig& robot, const VerdictConfig& config)
{
	Opening opening;
	opening.center = end.center;
	opening.normal = end.normal;
	opening.frame.left = {-0.5 * end.width_m, JambKind::corner, 1.0, end.left_rows};
	opening.frame.right = {0.5 * end.width_m, JambKind::corner, 1.0, end.right_rows};
	opening.measure.clear_width_m = end.clear_width_m;
	opening.measure.evidence.through = end.through;
	opening.measure.evidence.range_m = end.center.norm();
	const bool fits = end.clear_width_m >= 2.0 * robot.radius_m + config.width_margin_m;
	opening.verdict = {fits ? Verdict::passage : Verdict::blocked, fits ? 0.95 : 0.05};
	return opening;
}

namespace
{
/** As far as the face of a jamb is seen behind the wall's; else what walls inside buildings mostly have. */
double wallThickness(const OpeningMeasure& measure)
{
	constexpr double kUsual_m = 0.12, kThinnest_m = 0.05, kThickest_m = 0.45, kFewRays = 0.02;
	const bool seen = measure.reveal > kFewRays && measure.reveal_m > kThinnest_m && measure.reveal_m < kThickest_m;
	return seen ? measure.reveal_m : kUsual_m;
}
}  // namespace

Door doorOf(const Opening& opening, const LevelPose& pose)
{
	constexpr double kHeightUnknown_m = 2.0;  // the middle of a door whose top is out of view
	Door door;
	door.height_m = opening.measure.evidence.lintel_m;
	const double middle_m = 0.5 * door.height_m.value_or(kHeightUnknown_m);
	const Eigen::Vector2d center = opening.center - 0.5 * wallThickness(opening.measure) * opening.normal;
	door.center = pose.robot_from_level * Eigen::Vector3d(center.x(), center.y(), middle_m);
	door.normal = pose.robot_from_level.linear() * Eigen::Vector3d(opening.normal.x(), opening.normal.y(), 0.0);
	door.width_m = opening.frame.width_m();
	door.clear_width_m = opening.measure.clear_width_m;
	door.verdict = opening.verdict.verdict;
	door.confidence = opening.verdict.confidence;
	door.evidence = opening.measure.evidence;
	return door;
}
}  // namespace explore
