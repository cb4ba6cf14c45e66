// Whether a track is really there: log-odds over looks, confirmed after three of five.
#pragma once

#include <explore/config/fields.h>

#include <Eigen/Geometry>

namespace explore
{
/** From where and when something was looked at. */
struct Viewpoint
{
	Eigen::Isometry3d map_from_camera = Eigen::Isometry3d::Identity();
	double t_s = 0;  ///< mrpt::Clock::toDouble
};

/** A frame counts as a look when it is at least 5 cm, 3° or 0.2 s after the last one. */
[[nodiscard]] bool isNewLook(const Viewpoint& last, const Viewpoint& now);

/** How much of what `now` says is news after `last`, `least` to 1: looks from one place share their errors. */
[[nodiscard]] double novelty(const Viewpoint& last, const Viewpoint& now, double least);

struct ExistenceConfig
{
	int confirm_hits = 3, confirm_looks = 5;
	double confirm_probability = 0.8;  ///< of being there, beside the looks
	double drop_probability = 0.2;     ///< below, a track dies
	double max_probability = 0.998;    ///< never surer, so that what vanished can die
	double same_place_weight = 0.4;    ///< of a look from the place of the one before, by novelty()
};
/** Field list of the above; without a section of its own. */
void describe(FieldVisitor& fields, ExistenceConfig& config);

struct Existence
{
	double log_odds = 0;
	int looks = 0, hits = 0;
	unsigned recent = 0;  ///< a bit a look, the newest lowest: 1 = a hit
	bool confirmed = false;
	Viewpoint last_look, last_hit;
};

/** ln(p / (1 − p)) for p in (0, 1). */
[[nodiscard]] double logOdds(double probability);
/** The other way round. */
[[nodiscard]] double probabilityOf(double log_odds);

/** What one look said. */
struct LookResult
{
	Viewpoint from;
	bool hit = false;
	double log_odds = 0;  ///< ln(P(result | there) / P(result | not there)), as if no look had been before
};
/** Adds a look, weighted by its novelty, and confirms or unconfirms: confirmed with enough hits among the last looks
 * and enough probability, until it is more likely not there. */
void addLook(Existence& existence, const LookResult& look, const ExistenceConfig& config);

/** So unlikely that the track dies. */
[[nodiscard]] bool isDead(const Existence& existence, const ExistenceConfig& config);

/** One existence of two tracks that are the same thing: the surer one's, and all that confirmed either. */
[[nodiscard]] Existence joined(const Existence& a, const Existence& b);
}  // namespace explore
