#include <explore/perception/opening_verdict.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kNarrowed_m = 0.08;  // what stands in an opening takes at least this of its width
constexpr double kSomeWay = 0.02;     // of the rays lead on where a room is merely dark and large
constexpr double kWidestLeaf_m = 1.4;
constexpr double kLeaf_m = 1.0;                         // a leaf is higher
constexpr double kFace_m = 0.3;                         // of wall beside a wide passage
constexpr double kShown_m = 0.15;                       // of wall at the edge of the image, at least
constexpr double kPier_m = 0.5;                         // wall between two doors; pillars are narrower
constexpr double kHighLintel_m = 2.35;                  // from here on it may be the ceiling that meets the wall
constexpr double kCeiling_m = 2.2;                      // rooms are higher, furniture is lower
constexpr double kPaperMin_m = 0.8, kPaperMax_m = 1.6;  // th_g^min, th_g^max

double noReturnExcess(const OpeningMeasure& measure)
{
	return std::max(0.0, measure.evidence.no_return - measure.no_return_beside);
}

/** Wall that is surely no pillar and no face of another door's jamb. */
bool isSolid(const WallPiece& piece)
{
	return piece.length_m >= kPier_m || (!piece.ends && !piece.hidden && piece.length_m >= kShown_m);
}

/** Wall as far as one sees; or the corner of a room, where a wall across hides how it goes on. */
bool mayBeWall(const WallPiece& piece)
{
	return !piece.ends || piece.length_m >= kPier_m;
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
	const bool left = isSolid(context.left), right = isSolid(context.right);
	if (frame.width_m() > config.door_width_m)
		return std::min(context.left.length_m, context.right.length_m) >= (left && right ? 0.0 : kFace_m);
	return (left && mayBeWall(context.right)) || (right && mayBeWall(context.left));
}

/** Structure that no door or passage has. */
bool isNoDoor(const OpeningFrame& frame, const OpeningMeasure& measure, const OpeningContext& context,
              const VerdictConfig& config)
{
	const OpeningEvidence& evidence = measure.evidence;
	if (frame.width_m() < config.min_report_m || measure.rays < 20) return true;
	if (config.height_profile && evidence.lintel_m && *evidence.lintel_m < config.min_lintel_m) return true;
	if (config.height_profile && evidence.sill > config.max_sill) return true;
	if (!config.robot_size && (frame.width_m() < kPaperMin_m || frame.width_m() > kPaperMax_m)) return true;
	if (frame.left.kind == JambKind::nothing || frame.right.kind == JambKind::nothing) return true;
	if (std::max(evidence.left_wall, evidence.right_wall) < config.min_support) return true;
	return !isBuilt(frame, measure, context, config);
}

/** Seen from the side nothing but the far jamb's face, or a leaf that stands open there, may be in view: nothing stops
 *  the rays before it, the wall around is plain, and no back wall ends the opening. */
bool isSlot(const OpeningFrame& frame, const OpeningMeasure& measure, const OpeningContext& context)
{
	const OpeningEvidence& evidence = measure.evidence;
	const bool framed = frame.left.kind == JambKind::wall && frame.right.kind == JambKind::wall &&
	                    std::min(evidence.left_wall, evidence.right_wall) > 0.7 &&
	                    std::max(context.left.length_m, context.right.length_m) > 0.5;
	const bool high = measure.top_beside_m >= kCeiling_m && evidence.lintel_m.value_or(2.0) > 1.75 &&
	                  evidence.lintel_m.value_or(2.0) < 2.4;
	const double end_share = measure.reveal_m < 0.15 ? 0.0 : measure.back_wall * measure.reveal_m / 0.5;
	return framed && high && measure.reveal > 0.5 && evidence.stopped < 0.15 && end_share < 0.25;
}

bool leadsNowhere(const OpeningFrame& frame, const OpeningMeasure& measure, const OpeningContext& context,
                  const VerdictConfig& config)
{
	return measure.evidence.through < config.min_through && noReturnExcess(measure) < config.max_no_return &&
	       !isSlot(frame, measure, context);
}

/** Something swallows the rays: all of them (black), or some here and there (glass). What is merely out of range is
 *  missing as a whole, beside rays that lead on. */
bool isOpaque(const OpeningMeasure& measure, const VerdictConfig& config)
{
	const OpeningEvidence& evidence = measure.evidence;
	if (evidence.speckle - measure.holes_beside > config.max_speckle && noReturnExcess(measure) > config.pane_no_return)
		return true;
	const bool floor_seen = evidence.through > kSomeWay && evidence.floor_beyond &&
	                        *evidence.floor_beyond > config.min_floor &&
	                        measure.floor_missing < config.max_floor_missing;
	return noReturnExcess(measure) > config.max_no_return && evidence.through < config.min_through && !floor_seen;
}

Verdict passableKind(const OpeningFrame& frame, const OpeningMeasure& measure, const VerdictConfig& config)
{
	const bool no_lintel = !measure.evidence.lintel_m && measure.evidence.highest_seen_m > 2.3;
	return no_lintel || frame.width_m() > config.door_width_m ? Verdict::passage : Verdict::open;
}

std::optional<Verdict> verdictOf(const OpeningFrame& frame, const OpeningMeasure& measure,
                                 const OpeningContext& context, const VerdictConfig& config)
{
	const OpeningEvidence& evidence = measure.evidence;
	if (leadsNowhere(frame, measure, context, config))
	{
		const bool leaf = evidence.stopped > 0.6 && measure.stop_depth_m < config.max_recess_m;
		const bool framed = frame.left.kind == JambKind::wall && frame.right.kind == JambKind::wall;
		if (leaf && framed && frame.width_m() < kWidestLeaf_m) return Verdict::closed;
		return std::nullopt;
	}
	if (isOpaque(measure, config)) return Verdict::unknown;
	const bool unseen = frame.left.kind == JambKind::hidden || frame.right.kind == JambKind::hidden ||
	                    frame.left.kind == JambKind::out_of_view || frame.right.kind == JambKind::out_of_view;
	if (unseen)
	{
		// Only beside a wall that surely is one.
		const double length_m = std::max(context.left.length_m, context.right.length_m);
		if (!evidence.lintel_m && length_m < 2.0 * config.pillar_m) return std::nullopt;
		return Verdict::partial;
	}
	if (config.floor_beyond && measure.floor_missing > config.max_floor_missing) return Verdict::drop;
	if (config.floor_beyond && evidence.floor_beyond && *evidence.floor_beyond < config.min_floor) return Verdict::drop;
	const bool narrowed = measure.clear_width_m < frame.width_m() - kNarrowed_m;
	if (narrowed && measure.at_jamb && measure.standing_m > kLeaf_m) return Verdict::ajar;
	// An opening that is too narrow by itself is open for smaller robots: clear_width says so.
	if (narrowed && measure.clear_width_m < context.needed_width_m) return Verdict::blocked;
	return passableKind(frame, measure, config);
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
	            "A piece of wall narrower than this, with nothing above that joins it to the next, is a pillar.");
}

std::array<double, kOpeningFeatures> openingFeatures(const OpeningFrame& frame, const OpeningMeasure& measure,
                                                     const OpeningContext& context)
{
	const OpeningEvidence& evidence = measure.evidence;
	const bool corner = frame.left.kind == JambKind::corner || frame.right.kind == JambKind::corner;
	const double width_m = std::max(0.1, frame.width_m());
	return {1.0,
	        evidence.through,
	        noReturnExcess(measure),
	        std::min(0.2, std::max(0.0, evidence.speckle - measure.holes_beside)),
	        std::min(frame.left.support, frame.right.support),
	        std::clamp(measure.clear_width_m - context.needed_width_m, -0.3, 0.3),
	        std::min(1.0, measure.through_run_m / width_m),
	        evidence.floor_beyond.value_or(1.0),
	        evidence.floor_beyond ? 0.0 : 1.0,
	        evidence.occluded,
	        evidence.lintel_m ? 1.0 : 0.0,
	        evidence.sill,
	        evidence.range_m,
	        evidence.lowest_seen_m > 0.5 ? 1.0 : 0.0,
	        corner ? 1.0 : std::clamp(width_m - 1.4, 0.0, 1.0),
	        std::min(0.8, std::max(context.left.length_m, context.right.length_m)),
	        std::min(0.8, std::min(context.left.length_m, context.right.length_m)),
	        measure.reveal};
}

namespace
{
/** Logistic regression on openingFeatures() of openings that look passable; see doc/method.md for how it was fitted. */
double passProbability(const std::array<double, kOpeningFeatures>& features)
{
	static constexpr std::array<double, kOpeningFeatures> kWeights{-0.445, 2.461,  0.568,  -0.120, 0.615, 5.290,
	                                                               0.342,  -0.347, 0.469,  -1.191, 1.107, -0.965,
	                                                               -0.271, -1.566, -1.102, -0.531, 1.889, 1.551};
	double sum = 0;
	for (std::size_t i = 0; i < features.size(); ++i) sum += kWeights.at(i) * features.at(i);
	return 1.0 / (1.0 + std::exp(-sum));
}

/** How often an opening with such a verdict could be passed after all, in the scenes of that fit. */
double rateOf(Verdict verdict)
{
	switch (verdict)
	{
		case Verdict::unknown:
			return 0.20;
		case Verdict::partial:
		case Verdict::blocked:
			return 0.03;
		default:
			return 0.01;
	}
}
}  // namespace

std::optional<OpeningVerdict> judgeOpening(const OpeningFrame& frame, const OpeningMeasure& measure,
                                           const OpeningContext& context, const VerdictConfig& config)
{
	if (isNoDoor(frame, measure, context, config)) return std::nullopt;
	const auto verdict = verdictOf(frame, measure, context, config);
	if (!verdict) return std::nullopt;
	const bool fits = measure.clear_width_m >= context.needed_width_m;
	const bool passable = *verdict == Verdict::open || *verdict == Verdict::passage || *verdict == Verdict::ajar;
	return OpeningVerdict{
	    *verdict, passable && fits ? passProbability(openingFeatures(frame, measure, context)) : rateOf(*verdict)};
}
}  // namespace explore
