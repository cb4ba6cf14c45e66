#include <explore/core/geometry.h>
#include <explore/memory/track_existence.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kLook_m = 0.05, kLook_rad = 3 * kDegree_rad, kLook_s = 0.2;
// A view is another one after a step or a turn like these.
constexpr double kOtherView_m = 0.25, kOtherView_rad = 10 * kDegree_rad;
constexpr double kRounding = 1e-9;  // of times and places that are said to be apart by a round number

struct Move
{
	double distance_m = 0, angle_rad = 0;
};

Move between(const Viewpoint& a, const Viewpoint& b)
{
	const Eigen::Isometry3d move = a.map_from_camera.inverse(Eigen::Isometry) * b.map_from_camera;
	return {move.translation().norm(), Eigen::AngleAxisd(move.linear()).angle()};
}
}  // namespace

bool isNewLook(const Viewpoint& last, const Viewpoint& now)
{
	if (now.t_s - last.t_s >= kLook_s - kRounding) return true;
	const Move move = between(last, now);
	return move.distance_m >= kLook_m - kRounding || move.angle_rad >= kLook_rad - kRounding;
}

double novelty(const Viewpoint& last, const Viewpoint& now, double least)
{
	const Move move = between(last, now);
	const double share = std::max(move.distance_m / kOtherView_m, move.angle_rad / kOtherView_rad);
	return least + (1 - least) * std::min(share, 1.0);
}

void describe(FieldVisitor& fields, ExistenceConfig& config)
{
	fields.integer("confirm_hits", config.confirm_hits, {1, 30}, "", "A track is confirmed when so many ...");
	fields.integer("confirm_looks", config.confirm_looks, {1, 30}, "", "... of its last so many looks have shown it.");
	fields.real("confirm_probability", config.confirm_probability, {0.5, 0.999}, "",
	            "It has to be there at least this surely to be confirmed.");
	fields.real("drop_probability", config.drop_probability, {0.001, 0.5}, "",
	            "A track that is there less surely than this is forgotten.");
	fields.real("sure_probability", config.max_probability, {0.51, 0.99999}, "",
	            "A track is never surer than this, so that what has gone can be forgotten.");
	fields.real("same_place_weight", config.same_place_weight, {0.01, 1.0}, "",
	            "Weight of a look from the very place of the one before; 1 from 0.25 m or 10 degrees on.");
}

double logOdds(double probability)
{
	return std::log(probability / (1 - probability));
}

double probabilityOf(double log_odds)
{
	return 1 / (1 + std::exp(-log_odds));
}

void addLook(Existence& existence, const LookResult& look, const ExistenceConfig& config)
{
	const bool first = existence.looks == 0;
	const double weight = first ? 1.0 : novelty(existence.last_look, look.from, config.same_place_weight);
	const double most = logOdds(config.max_probability);
	existence.log_odds = std::clamp(existence.log_odds + weight * look.log_odds, -most, most);
	existence.recent = (existence.recent << 1U) | (look.hit ? 1U : 0U);
	++existence.looks;
	existence.last_look = look.from;
	if (look.hit)
	{
		++existence.hits;
		existence.last_hit = look.from;
	}
	const unsigned window = (1U << static_cast<unsigned>(config.confirm_looks)) - 1U;
	if (std::popcount(existence.recent & window) >= config.confirm_hits &&
	    existence.log_odds >= logOdds(config.confirm_probability))
		existence.confirmed = true;
	else if (existence.log_odds < 0)
		existence.confirmed = false;
}

bool isDead(const Existence& existence, const ExistenceConfig& config)
{
	return existence.log_odds < logOdds(config.drop_probability);
}

Existence joined(const Existence& a, const Existence& b)
{
	Existence result = a.log_odds >= b.log_odds ? a : b;
	result.confirmed = a.confirmed || b.confirmed;
	result.looks = std::max(a.looks, b.looks);
	result.hits = std::max(a.hits, b.hits);
	result.recent = a.recent | b.recent;
	if (a.last_look.t_s > result.last_look.t_s) result.last_look = a.last_look;
	if (b.last_look.t_s > result.last_look.t_s) result.last_look = b.last_look;
	if (a.last_hit.t_s > result.last_hit.t_s) result.last_hit = a.last_hit;
	if (b.last_hit.t_s > result.last_hit.t_s) result.last_hit = b.last_hit;
	return result;
}
}  // namespace explore
