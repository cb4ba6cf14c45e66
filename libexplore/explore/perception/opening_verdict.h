// From measurements to a verdict and a probability that the robot can pass.
#pragma once

#include <explore/perception/opening_features.h>

#include <optional>

namespace explore
{
struct VerdictConfig
{
	double min_report_m = 0.45;      ///< narrower openings are nobody's door
	double door_width_m = 1.6;       ///< wider ones are passages (th_g^max)
	double width_margin_m = 0.10;    ///< the robot needs its diameter + this
	double min_lintel_m = 1.4;       ///< a lower top is furniture
	double max_sill = 0.7;           ///< share of wall below knee height: more is a window
	double max_no_return = 0.35;     ///< of the rays, beyond what the wall beside loses: more is unknown
	double max_speckle = 0.05;       ///< of holes amid near surfaces, beyond those in the wall beside: glass, where
	double pane_no_return = 0.1;     ///< this share of the rays, beyond what the wall beside loses, is missing
	double max_range_m = 5.1;        ///< of either jamb: further away a wall is not surely one
	double min_through = 0.15;       ///< of the rays: less leads nowhere
	double max_recess_m = 0.25;      ///< a leaf stands within this behind the wall's face
	double min_floor = 0.88;         ///< of the rays that should meet floor behind: less is a drop
	double max_floor_missing = 0.7;  ///< of the rays to near floor behind: more is a drop as well
	double pillar_m = 0.5;           ///< a piece of wall that ends in view before this length may be a pillar
	double partial_wall_m = 1.0;     ///< of wall beside an opening whose other jamb, and lintel, are out of view
	double min_confidence = 0.5;     ///< P(the robot can pass) from which on an opening is passable
	// For comparison, the remedies of method.md one by one:
	bool height_profile = true;  ///< sill and lintel count
	bool leaf = true;            ///< what stands in the opening counts
	bool robot_size = true;      ///< false: only the paper's 0.8–1.6 m are doors
	bool floor_beyond = true;    ///< a missing floor counts
};
void describe(FieldVisitor& fields, VerdictConfig& config);

struct OpeningVerdict
{
	Verdict verdict = Verdict::unknown;
	double confidence = 0;  ///< P(the robot can pass now)
};

/** Passable where passProbability() is high enough, unless something swallows the rays or the floor is missing; else
 *  rules tell why not. No value: not an opening that anybody would call a door or a passage (window, niche, gap between
 *  furniture, shadow). */
std::optional<OpeningVerdict> judgeOpening(const OpeningFrame& frame, const OpeningMeasure& measure,
                                           const OpeningContext& context, const VerdictConfig& config);
}  // namespace explore
