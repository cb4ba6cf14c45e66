#include <explore/perception/opening_features.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kNone = -1.0;        // where a thing was not seen
constexpr double kFewReveals = 0.05;  // of the rays: fewer tell nothing about a face

struct NamedValue
{
	std::string_view name;
	double value;
};

int count(const OpeningFrame& frame, JambKind kind)
{
	return static_cast<int>(frame.left.kind == kind) + static_cast<int>(frame.right.kind == kind);
}

/** The shorter one of those pieces of wall that end in view: a pillar, where it is short. */
double shortestEnding(const OpeningContext& context)
{
	constexpr double kLong_m = 3.0;
	const auto length = [](const WallPiece& piece) { return piece.ends ? piece.length_m : kLong_m; };
	return std::min(length(context.left), length(context.right));
}

std::array<NamedValue, kOpeningFeatures> namedFeatures(const OpeningFrame& frame, const OpeningMeasure& measure,
                                                       const OpeningContext& context)
{
	const OpeningEvidence& evidence = measure.evidence;
	const double width_m = std::max(0.1, frame.width_m());
	const double no_return = std::max(0.0, evidence.no_return - measure.no_return_beside);
	const double incidence_rad = std::acos(std::min(1.0, context.distance_m / std::max(0.01, evidence.range_m)));
	// Seen at an angle, rays that enter beside the near jamb reach the far jamb's face this far behind the wall.
	const double deepest_m = width_m / std::max(0.05, std::tan(incidence_rad));
	const bool revealed = measure.reveal > kFewReveals, stopped = evidence.stopped > kFewReveals;
	const auto [shorter, longer] = std::minmax(context.left.length_m, context.right.length_m);
	const auto [less_wall, more_wall] = std::minmax(evidence.left_wall, evidence.right_wall);
	const auto [less_across, more_across] = std::minmax(measure.across_left, measure.across_right);
	return {
	    {{"through", evidence.through},
	     {"no_return", no_return},
	     {"no_return_beside", measure.no_return_beside},
	     {"speckle", evidence.speckle - measure.holes_beside},
	     {"stopped", evidence.stopped},
	     {"stop_depth", stopped ? measure.stop_depth_m : kNone},
	     {"occluded", evidence.occluded},
	     {"reveal", measure.reveal},
	     {"reveal_depth", revealed ? measure.reveal_m : kNone},
	     {"reveal_depth_of_deepest", revealed ? measure.reveal_m / std::max(0.05, deepest_m) : kNone},
	     {"back_wall", revealed ? measure.back_wall : kNone},
	     {"through_run", measure.through_run_m / width_m},
	     {"seen_lane", measure.seen_lane_m - context.needed_width_m},
	     {"seen_lane_share", measure.seen_lane_m / width_m},
	     {"width", width_m},
	     {"slack", measure.clear_width_m - context.needed_width_m},
	     {"narrowed", width_m - measure.clear_width_m},
	     {"standing", measure.standing_m},
	     {"at_jamb", measure.at_jamb ? 1.0 : 0.0},
	     {"incidence", incidence_rad},
	     {"range", evidence.range_m},
	     {"distance", context.distance_m},
	     {"sill", evidence.sill},
	     {"lintel", evidence.lintel_m.value_or(kNone)},
	     {"highest_seen", evidence.lintel_m ? 3.0 : evidence.highest_seen_m},
	     {"lowest_seen", evidence.lowest_seen_m},
	     {"top_beside", measure.top_beside_m},
	     {"floor_beyond", evidence.floor_beyond.value_or(kNone)},
	     {"floor_missing", measure.floor_missing},
	     {"longer_piece", longer},
	     {"shorter_piece", shorter},
	     {"shortest_ending", shortestEnding(context)},
	     {"hidden_pieces", static_cast<double>(context.left.hidden) + static_cast<double>(context.right.hidden)},
	     {"less_wall", less_wall},
	     {"more_wall", more_wall},
	     {"less_across", less_across},
	     {"more_across", more_across},
	     {"support", std::min(frame.left.support, frame.right.support)},
	     {"corners", static_cast<double>(count(frame, JambKind::corner))},
	     {"unseen_jambs", static_cast<double>(count(frame, JambKind::hidden) + count(frame, JambKind::out_of_view))},
	     {"wall_length", context.wall_length_m},
	     {"longest_piece", context.longest_piece_m}}};
}
}  // namespace

OpeningFeatures openingFeatures(const OpeningFrame& frame, const OpeningMeasure& measure, const OpeningContext& context)
{
	OpeningFeatures features{};
	std::ranges::transform(namedFeatures(frame, measure, context), features.begin(),
	                       [](const NamedValue& feature) { return static_cast<float>(feature.value); });
	return features;
}

const std::array<std::string_view, kOpeningFeatures>& openingFeatureNames()
{
	static const auto kNames = []
	{
		std::array<std::string_view, kOpeningFeatures> names{};
		std::ranges::transform(namedFeatures({}, {}, {}), names.begin(), &NamedValue::name);
		return names;
	}();
	return kNames;
}
}  // namespace explore
