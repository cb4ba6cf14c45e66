#include <explore/perception/openings.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
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

std::vector<Opening> findOpenings(const LevelView& view, const std::vector<UprightWall>& walls,
                                  const RobotConfig& robot, const OpeningsConfig& config,
                                  const SensorNoiseConfig& noise)
{
	std::vector<Opening> judged;
	for (Opening& opening : measuredOpenings(view, walls, robot, config, noise))
		if (const auto verdict = judgeOpening(opening.frame, opening.measure, opening.context, config.verdict))
		{
			opening.verdict = *verdict;
			judged.push_back(std::move(opening));
		}
	return distinct(std::move(judged));
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
