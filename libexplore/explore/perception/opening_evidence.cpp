#include <explore/perception/clear_width.h>
#include <explore/perception/far_jamb.h>
#include <explore/perception/opening_evidence.h>
#include <explore/perception/opening_rays.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr int kFewInBin = 8;

/** Height where the wall begins again above the opening: the first bin, from door height on, that is mostly wall. */
std::optional<double> lintelHeight(const std::vector<RayCounts>& heights)
{
	constexpr double kOverSills_m = 0.5;
	constexpr std::size_t kBins = 3;  // of wall: a ceiling that meets the wall's plane is thinner
	// Where most rays are lost, the few that return at an opening's edges say nothing about its middle.
	constexpr double kReturned = 0.35;
	const auto wall_share = [](const RayCounts& bin) { return shareOf(bin.wall, bin.all - bin.nothing); };
	const auto is_wall = [&](std::size_t i)
	{
		return i < heights.size() && heights[i].all >= kFewInBin && wall_share(heights[i]) >= 0.5 &&
		       shareOf(heights[i].wall, heights[i].all) >= kReturned;
	};
	for (auto i = static_cast<std::size_t>(kOverSills_m / kRayHeightBin_m); i < heights.size(); ++i)
	{
		bool goes_on = true;
		for (std::size_t k = 0; k < kBins; ++k) goes_on = goes_on && is_wall(i + k);
		if (!goes_on) continue;
		// The bin in which it begins is partly wall, and so may be the one below.
		const double below = heights[i - 1].all < kFewInBin ? 0.0 : wall_share(heights[i - 1]);
		return kRayHeightBin_m * (static_cast<double>(i + 1) - wall_share(heights[i]) - below);
	}
	return std::nullopt;
}

double sillShare(const std::vector<RayCounts>& heights)
{
	constexpr double kFrom_m = 0.1, kKnee_m = 0.5, kReturned = 0.25;
	RayCounts sum;
	for (auto i = static_cast<std::size_t>(kFrom_m / kRayHeightBin_m);
	     i < static_cast<std::size_t>(kKnee_m / kRayHeightBin_m); ++i)
	{
		sum.all += heights[i].all - heights[i].front;
		sum.nothing += heights[i].nothing;
		sum.wall += heights[i].wall + heights[i].beside;
	}
	const int returned = sum.all - sum.nothing;
	return returned < kFewInBin || shareOf(returned, sum.all) < kReturned ? 0.0 : shareOf(sum.wall, returned);
}

double longestThrough(const std::vector<RayCounts>& strips)
{
	std::size_t run = 0, longest = 0;
	for (const RayCounts& strip : strips)
	{
		const int seen = strip.all - strip.front;
		run = seen > 0 && 2 * strip.through >= seen ? run + 1 : 0;
		longest = std::max(longest, run);
	}
	return static_cast<double>(longest) * kRayStrip_m;
}

/** Top of what stands beside an opening: from there on rays pass behind it. The highest seen where none does. */
double topOf(const std::vector<RayCounts>& heights)
{
	constexpr std::size_t kFewBins = 3;  // of sight over the top
	std::size_t top = heights.size(), over = 0;
	for (std::size_t i = heights.size(); i-- > 0;)
	{
		const RayCounts& bin = heights[i];
		const int seen = bin.all - bin.nothing;
		if (seen < kFewInBin) continue;
		if (2 * bin.behind() < seen) break;
		++over;
		top = i;
	}
	return over < kFewBins ? kRayTop_m : static_cast<double>(top) * kRayHeightBin_m;
}

/** Their 90th percentile. */
double highest(std::vector<float>& values)
{
	if (values.empty()) return 0.0;
	const auto nth = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 9 / 10);
	std::ranges::nth_element(values, nth);
	return *nth;
}

/** Share of the values within a few centimetres of their highest: a face seen from the side has few, a niche's back
 *  wall has them all. */
double shareAtTheEnd(const std::vector<float>& values, double highest_m)
{
	constexpr double kNear_m = 0.05;
	const auto near = std::ranges::count_if(values, [&](float value) { return value > highest_m - kNear_m; });
	return shareOf(static_cast<int>(near), static_cast<int>(values.size()));
}

/** Obstacles without those further before the opening than `front_m`, unless they reach out from it as a leaf does. */
std::vector<Eigen::Vector2d> inTheWay(const std::vector<Eigen::Vector2d>& obstacles, double width_m, double front_m)
{
	constexpr double kHop_m = 0.13;
	std::vector<Eigen::Vector2d> kept, before;
	kept.reserve(obstacles.size());
	for (const auto& point : obstacles) (point.y() >= -front_m ? kept : before).push_back(point);
	// Only what hangs on a jamb can be a leaf.
	std::vector<Eigen::Vector2d> leaf{{0.0, 0.0}, {width_m, 0.0}};
	for (std::size_t i = 0; i < leaf.size(); ++i)
		for (const auto* points : {&kept, &before})
			for (const auto& point : *points)
				if ((point - leaf[i]).norm() < kHop_m && std::ranges::find(leaf, point) == leaf.end())
					leaf.push_back(point);
	for (const auto& point : leaf)
		if (point.y() < -front_m) kept.push_back(point);
	return kept;
}

double standingShare(const RayCounts& side)
{
	return shareOf(side.wall, side.all - side.nothing);
}
OpeningEvidence evidenceOf(const RayTally& tally)
{
	OpeningEvidence evidence;
	const int seen = tally.body.all - tally.body.front + tally.reveals;
	evidence.through = shareOf(tally.body.through, seen);
	evidence.stopped = shareOf(tally.body.stopped + tally.body.wall + tally.body.beside, seen);
	evidence.no_return = shareOf(tally.body.nothing, seen);
	evidence.occluded = shareOf(tally.body.front, tally.body.all);
	evidence.speckle = tally.holes.share();
	evidence.left_wall = standingShare(tally.left);
	evidence.right_wall = standingShare(tally.right);
	evidence.sill = sillShare(tally.heights);
	evidence.lintel_m = lintelHeight(tally.heights);
	evidence.lowest_seen_m = tally.lowest_m;
	evidence.highest_seen_m = tally.highest_m;
	const int far_rays = tally.far_floor + tally.no_far_floor;
	const int near_rays = tally.floor + tally.below_floor;
	if (near_rays >= kFewInBin)
		evidence.floor_beyond = shareOf(tally.floor, near_rays);
	else if (far_rays >= kFewInBin)
		evidence.floor_beyond = shareOf(tally.far_floor, far_rays);
	return evidence;
}
}  // namespace

void describe(FieldVisitor& fields, OpeningConfig& config)
{
	fields.real("max_opening", config.max_width_m, {0.5, 20.0}, "m", "Wider openings of a wall are not looked at.");
	fields.real("depth_margin", config.length_margin_m, {0.0, 2.0}, "m",
	            "Behind an opening as much as the robot's diameter and this must be free.");
	fields.real("front_zone", config.front_m, {0.0, 2.0}, "m",
	            "What stands nearer than this before an opening narrows it.");
	fields.real("standing_top", config.standing_top_m, {0.2, 4.0}, "m",
	            "What stands in an opening is looked for up to this height, or the robot's if that is more.");
	fields.integer("opening_rays", config.rays, {500, 1e6}, "rays", "Looked at for each opening, about.");
}

OpeningMeasure measureOpening(const RayJudge& judge, const LevelView& view, const UprightWall& wall,
                              const OpeningFrame& frame, const BodyBand& body, double free_depth_m,
                              const OpeningConfig& config)
{
	const DepthImage& image = *view.image;
	const PixelBox box = judge.rays().boxOf(
	    {frame.left.along_m - kBesideOpening_m, frame.right.along_m + kBesideOpening_m, 0.0, kRayTop_m});
	const int step =
	    std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<double>(box.pixels()) / config.rays))));
	const Eigen::Vector2d middle = wall.at(frame.middle_m());
	const double range_m = middle.norm();
	const double pixels_per_m = image.intrinsics.fx_px / std::max(0.3, range_m + 0.5 * free_depth_m) / step;
	DoorwayPlan plan(frame.width_m(), config.leaf_m, free_depth_m, pixels_per_m * pixels_per_m);
	OpeningRays pass(judge, image, frame, body, free_depth_m, config.leaf_m, plan);
	for (int v = box.first_v; v <= box.last_v; v += step)
		for (int u = box.first_u; u <= box.last_u; u += step) pass.take(u, v);

	RayTally& tally = pass.tally();
	OpeningMeasure measure;
	measure.evidence = evidenceOf(tally);
	measure.evidence.range_m = range_m;
	measure.rays = tally.body.all - tally.body.front + tally.reveals;
	measure.no_return_beside = shareOf(tally.wall_nothing, tally.wall_rays);
	measure.holes_beside = tally.wall_holes.share();
	measure.floor_missing = tally.near_floor < 2 * kFewInBin ? 0.0 : shareOf(tally.no_floor, tally.near_floor);
	measure.through_run_m = longestThrough(tally.strips);
	measure.stop_depth_m = medianOf(tally.stop_depths_m);
	measure.top_beside_m = std::min(topOf(tally.left_heights), topOf(tally.right_heights));
	measure.reveal_m = highest(tally.reveal_depths_m);
	measure.back_wall = shareAtTheEnd(tally.reveal_depths_m, measure.reveal_m);
	measure.reveal = shareOf(tally.reveals, measure.rays);
	const auto obstacles = inTheWay(plan.obstacles(), frame.width_m(), config.front_m);
	measure.clear_width_m = clearWidth(frame.width_m(), obstacles);
	measure.seen_lane_m = plan.seenLane_m();
	measure.across_left = shareOf(tally.left.beside + tally.left.front, tally.left.all);
	measure.across_right = shareOf(tally.right.beside + tally.right.front, tally.right.all);
	measure.standing_m = plan.top_m();
	constexpr double kHinge_m = 0.2;
	measure.at_jamb = std::ranges::any_of(
	    obstacles, [&](const Eigen::Vector2d& point)
	    { return std::abs(point.y()) < kHinge_m && std::min(point.x(), frame.width_m() - point.x()) < kHinge_m; });
	return measure;
}
}  // namespace explore
