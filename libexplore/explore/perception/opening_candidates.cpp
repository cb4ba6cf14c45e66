#include <explore/perception/far_jamb.h>
#include <explore/perception/opening_candidates.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kNearest_m = 0.4;      // that the camera sees
constexpr double kUsualWall_m = 0.10;   // deep, at least
constexpr double kFaceInView_m = 0.03;  // along the wall: so much of a jamb's face would be noticed …
constexpr double kFaceSeen = 0.15;      // … as this share of the rays just inside the edge

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
 *  that is within the tolerance behind the wall they count as wall. Walls too thin to have a face show none where one
 *  as deep as walls usually have would be seen. */
double hiddenBySurface(const RayJudge& judge, const UprightWall& wall, const Jamb& jamb, JambSide side)
{
	const double outward_m = side == JambSide::right ? jamb.along_m : -jamb.along_m;
	if (outward_m <= 0.0 || jamb.kind != JambKind::wall) return 0.0;
	const double depth_m = std::max(kNearest_m, wall.at(jamb.along_m).x());
	const double tolerance_m =
	    judge.tolerance_m() + judge.noiseOf(static_cast<float>(depth_m)) * judge.distance_m() / depth_m;
	const double slope = outward_m / judge.distance_m();
	const bool shows_face = (kUsualWall_m - tolerance_m) * slope > kFaceInView_m;
	return shows_face && jamb.face < kFaceSeen ? 0.0 : tolerance_m * slope;
}

/** How much further out an edge that stands before the plane, as a casing does, is seen on the plane. */
double behindRelief(const RayJudge& judge, const Jamb& jamb)
{
	return jamb.kind == JambKind::wall ? jamb.along_m * jamb.relief_m / judge.distance_m() : 0.0;
}

/** The ends of an opening at a stretch of the wall; no value where an end does not stand, or is too far away. */
std::optional<OpeningFrame> frameAt(const RayJudge& judge, const UprightWall& wall, const Stretch& stretch,
                                    const BodyBand& body, const OpeningsConfig& config)
{
	OpeningFrame frame{fitJamb(judge, stretch.from_m, JambSide::left, config.rays, config.jambs),
	                   fitJamb(judge, stretch.to_m, JambSide::right, config.rays, config.jambs)};
	const bool stands = frame.left.kind != JambKind::nothing && frame.right.kind != JambKind::nothing;
	if (!stands || frame.width_m() < config.verdict.min_report_m) return std::nullopt;
	if (config.jambs.full_resolution)
	{
		frame.left.along_m -= behindRelief(judge, frame.left);
		frame.right.along_m -= behindRelief(judge, frame.right);
		frame.left.along_m -= hiddenBySurface(judge, wall, frame.left, JambSide::left);
		frame.right.along_m += hiddenBySurface(judge, wall, frame.right, JambSide::right);
	}
	// What is taken off at the ends may be more than there is between them.
	if (frame.width_m() < config.verdict.min_report_m) return std::nullopt;
	const double range_m = std::max(wall.at(frame.left.along_m).norm(), wall.at(frame.right.along_m).norm());
	if (range_m > config.verdict.max_range_m) return std::nullopt;
	if (config.jambs.full_resolution) frame = withFarJambFromFace(judge, frame, body);
	return frame.width_m() < config.verdict.min_report_m ? std::nullopt : std::optional(frame);
}

OpeningContext contextOf(const OpeningFrame& frame, const UprightWall& wall, const WallProfile& profile,
                         double needed_width_m)
{
	OpeningContext context;
	context.needed_width_m = needed_width_m;
	context.left = pieceBeside(profile, frame.left.along_m, JambSide::left);
	context.right = pieceBeside(profile, frame.right.along_m, JambSide::right);
	context.wall_length_m = wall.to_m - wall.from_m;
	context.longest_piece_m = wall.longest_piece_m;
	context.distance_m = wall.offset_m;
	return context;
}
}  // namespace

void describe(FieldVisitor& fields, OpeningsConfig& config)
{
	describe(fields, config.rays);
	describe(fields, config.measure);
	describe(fields, config.verdict);
}

std::vector<Opening> measuredOpenings(const LevelView& view, const std::vector<UprightWall>& walls,
                                      const RobotConfig& robot, const OpeningsConfig& config,
                                      const SensorNoiseConfig& noise)
{
	const double free_depth_m =
	    config.measure.depth_behind ? 2.0 * robot.radius_m + config.measure.length_margin_m : 0.0;
	const double needed_width_m = 2.0 * robot.radius_m + config.verdict.width_margin_m;
	const BodyBand body = bodyBand(robot, config);
	std::vector<Opening> openings;
	for (std::size_t i = 0; i < walls.size(); ++i)
	{
		const UprightWall& wall = walls[i];
		const RayJudge judge(view, wall, free_depth_m, config.rays, noise);
		const WallProfile profile = wallProfile(judge, view, wall, config.measure.max_width_m, config.rays);
		for (const Stretch& stretch :
		     candidateStretches(profile, config.verdict.min_report_m - profile.strip_m, config.measure.max_width_m))
		{
			const auto frame = frameAt(judge, wall, stretch, body, config);
			if (!frame) continue;
			Opening opening;
			opening.frame = *frame;
			opening.measure = measureOpening(judge, view, wall, *frame, body, free_depth_m, config.measure);
			if (!config.verdict.leaf) opening.measure.clear_width_m = frame->width_m();
			opening.context = contextOf(*frame, wall, profile, needed_width_m);
			opening.wall = i;
			opening.center = wall.at(frame->middle_m());
			opening.normal = wall.normal;
			openings.push_back(opening);
		}
	}
	return openings;
}
}  // namespace explore
