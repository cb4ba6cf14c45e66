#include <explore/perception/opening_verdict.h>
#include <explore/perception/pass_probability.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kNarrowed_m = 0.08;  // what stands in an opening takes at least this of its width
constexpr double kWidestLeaf_m = 1.4;
constexpr double kMostly = 0.6;                         // of the rays end on a closed leaf
constexpr double kSomeWay = 0.02;                       // of the rays lead on where a room is merely dark and large
constexpr double kSurelyNot = 0.05;                     // P(pass) at most, of what swallows rays or has no floor
constexpr double kLeaf_m = 1.0;                         // a leaf is higher
constexpr double kFace_m = 0.3;                         // of wall beside a wide passage
constexpr double kShown_m = 0.15;                       // of wall at the edge of the image, at least
constexpr double kHighLintel_m = 2.35;                  // from here on it may be the ceiling that meets the wall
constexpr double kCeiling_m = 2.2;                      // rooms are higher, furniture is lower
constexpr double kPaperMin_m = 0.8, kPaperMax_m = 1.6;  // th_g^min, th_g^max

double noReturnExcess(const OpeningMeasure& measure)
{
	return std::max(0.0, measure.evidence.no_return - measure.no_return_beside);
}

/** Wall that is surely no pillar and no face of another door's jamb. */
bool isSolid(const WallPiece& piece, const VerdictConfig& config)
{
	return piece.length_m >= config.pillar_m || (!piece.ends && !piece.hidden && piece.length_m >= kShown_m);
}

/** Whether what stands beside the opening is part of the building: joined above by a lintel, or wall that goes up to
 *  the ceiling as far as one sees and is too long for a pillar, a person or a piece of furniture. */
bool isBuilt(const OpeningFrame& frame, const OpeningMeasure& measure, const OpeningContext& context,
             const VerdictConfig& config)
{
	const auto& lintel_m = measure.evidence.lintel_m;
	if (lintel_m && *lintel_m < kHighLintel_m) return true;
	if (measure.top_beside_m < kCeiling_m) return false;
	if (std::max(context.left.length_m, context.right.length_m) >= config.pillar_m) return true;
	const bool left = isSolid(context.left, config), right = isSolid(context.right, config);
	if (frame.width_m() > config.door_width_m)
		return std::min(context.left.length_m, context.right.length_m) >= (left && right ? 0.0 : kFace_m);
	// The corner of a room, where a wall across hides how it goes on, may be beside the other jamb.
	return (left && !context.right.ends) || (right && !context.left.ends);
}

/** Structure that no door or passage has. */
bool isNoDoor(const OpeningFrame& frame, const OpeningMeasure& measure, const VerdictConfig& config)
{
	const OpeningEvidence& evidence = measure.evidence;
	if (frame.width_m() < config.min_report_m || measure.rays < 20) return true;
	if (config.height_profile && evidence.lintel_m && *evidence.lintel_m < config.min_lintel_m) return true;
	if (config.height_profile && evidence.sill > config.max_sill) return true;
	if (!config.robot_size && (frame.width_m() < kPaperMin_m || frame.width_m() > kPaperMax_m)) return true;
	return frame.left.kind == JambKind::nothing || frame.right.kind == JambKind::nothing;
}

/** Glass swallows rays here and there amid the surfaces behind it; what is merely out of range is missing as a whole,
 *  beside rays that lead on. */
bool isGlass(const OpeningMeasure& measure, const VerdictConfig& config)
{
	return measure.evidence.speckle - measure.holes_beside > config.max_speckle &&
	       noReturnExcess(measure) > config.pane_no_return;
}

/** Nothing comes back from there but at most a floor: black, or a room whose end is out of range. */
bool isDark(const OpeningMeasure& measure, const VerdictConfig& config)
{
	const OpeningEvidence& evidence = measure.evidence;
	const bool floor_seen = evidence.through > kSomeWay && evidence.floor_beyond &&
	                        *evidence.floor_beyond > config.min_floor &&
	                        measure.floor_missing < config.max_floor_missing;
	return noReturnExcess(measure) > config.max_no_return && evidence.through < config.min_through && !floor_seen;
}

/** A floor that is not there behind the opening. */
bool isDrop(const OpeningMeasure& measure, const VerdictConfig& config)
{
	const auto& floor_beyond = measure.evidence.floor_beyond;
	return config.floor_beyond &&
	       (measure.floor_missing > config.max_floor_missing || (floor_beyond && *floor_beyond < config.min_floor));
}

bool isUnseen(const Jamb& jamb)
{
	return jamb.kind == JambKind::hidden || jamb.kind == JambKind::out_of_view;
}

Verdict passableVerdict(const OpeningFrame& frame, const OpeningMeasure& measure, const VerdictConfig& config)
{
	const bool narrowed = measure.clear_width_m < frame.width_m() - kNarrowed_m;
	const bool leaf = narrowed && measure.at_jamb && measure.standing_m > kLeaf_m && frame.width_m() < kWidestLeaf_m;
	if (leaf) return Verdict::ajar;
	const bool no_lintel = !measure.evidence.lintel_m && measure.evidence.highest_seen_m > 2.3;
	return no_lintel || frame.width_m() > config.door_width_m ? Verdict::passage : Verdict::open;
}

/** The verdict that nothing comes back from there, or that the floor is missing: whatever else is seen. */
std::optional<Verdict> veto(const OpeningMeasure& measure, const VerdictConfig& config)
{
	if (isGlass(measure, config) || isDark(measure, config)) return Verdict::unknown;
	return isDrop(measure, config) ? std::optional(Verdict::drop) : std::nullopt;
}

/** What an opening that cannot be passed is, as far as one sees; no value for what nobody would call a door. */
std::optional<Verdict> otherVerdict(const OpeningFrame& frame, const OpeningMeasure& measure,
                                    const OpeningContext& context, const VerdictConfig& config)
{
	const OpeningEvidence& evidence = measure.evidence;
	if (evidence.through < config.min_through && noReturnExcess(measure) < config.max_no_return)
	{
		const bool leaf = evidence.stopped > kMostly && measure.stop_depth_m < config.max_recess_m;
		const bool framed = frame.left.kind == JambKind::wall && frame.right.kind == JambKind::wall;
		return leaf && framed && frame.width_m() < kWidestLeaf_m ? std::optional(Verdict::closed) : std::nullopt;
	}
	if (isUnseen(frame.left) || isUnseen(frame.right))
	{
		const double length_m = std::max(context.left.length_m, context.right.length_m);
		const bool sure = evidence.lintel_m || length_m >= config.partial_wall_m;
		return sure ? std::optional(Verdict::partial) : std::nullopt;
	}
	// An opening that is too narrow by itself is open for smaller robots: clear_width says so.
	if (frame.width_m() < context.needed_width_m) return passableVerdict(frame, measure, config);
	return measure.clear_width_m < context.needed_width_m ? Verdict::blocked : Verdict::unknown;
}
}  // namespace

void describe(FieldVisitor& fields, VerdictConfig& config)
{
	fields.real("min_opening", config.min_report_m, {0.1, 5.0}, "m", "Narrower openings are not reported at all.");
	fields.real("door_width", config.door_width_m, {0.5, 10.0}, "m", "A wider opening is a passage, not a door.");
	fields.real("width_margin", config.width_margin_m, {0.0, 2.0}, "m",
	            "The robot fits an opening that is wider than itself by this.");
	fields.real("min_lintel", config.min_lintel_m, {0.2, 4.0}, "m", "An opening with a lower top is furniture.");
	fields.real("max_sill", config.max_sill, {0.0, 1.0}, "",
	            "More wall than this share below knee height is a window.");
	fields.real("max_no_return", config.max_no_return, {0.0, 1.0}, "",
	            "More rays than this share without return, beyond the loss on the wall beside, is unknown.");
	fields.real("max_speckle", config.max_speckle, {0.0, 1.0}, "",
	            "More single pixels than this share without return, beyond the loss on the wall beside, is glass.");
	fields.real("pane_no_return", config.pane_no_return, {0.0, 1.0}, "",
	            "A pane loses at least this share of the rays beyond what the wall beside loses.");
	fields.real("opening_max_range", config.max_range_m, {0.5, 100.0}, "m",
	            "Openings with a jamb further away are not reported.");
	fields.real("min_through", config.min_through, {0.0, 1.0}, "",
	            "An opening through which less than this share of the rays leads on leads nowhere.");
	fields.real("max_recess", config.max_recess_m, {0.01, 1.0}, "m",
	            "A closed leaf stands within this behind the wall.");
	fields.real("min_floor", config.min_floor, {0.0, 1.0}, "",
	            "Less floor than this share where floor should be seen behind the opening is a drop.");
	fields.real("max_floor_missing", config.max_floor_missing, {0.0, 1.0}, "",
	            "Near floor behind an opening of which more than this share returns nothing is a drop.");
	fields.real("pillar_width", config.pillar_m, {0.05, 2.0}, "m",
	            "Wall beside an opening that ends in view before this length, with no lintel above, may be a pillar.");
	fields.real("partial_wall", config.partial_wall_m, {0.1, 10.0}, "m",
	            "With a jamb and the lintel out of view, this much wall must be seen beside an opening to report it.");
	fields.real("min_confidence", config.min_confidence, {0.0, 1.0}, "",
	            "An opening is reported as passable from this probability on.");
}

std::optional<OpeningVerdict> judgeOpening(const OpeningFrame& frame, const OpeningMeasure& measure,
                                           const OpeningContext& context, const VerdictConfig& config)
{
	if (isNoDoor(frame, measure, config)) return std::nullopt;
	const double passable = passProbability(openingFeatures(frame, measure, context));
	const auto vetoed = veto(measure, config);
	if (!vetoed && passable >= config.min_confidence)
		return OpeningVerdict{passableVerdict(frame, measure, config), passable};
	if (!isBuilt(frame, measure, context, config)) return std::nullopt;
	if (vetoed) return OpeningVerdict{*vetoed, std::min(passable, kSurelyNot)};
	const auto other = otherVerdict(frame, measure, context, config);
	return other ? std::optional(OpeningVerdict{*other, passable}) : std::nullopt;
}
}  // namespace explore
