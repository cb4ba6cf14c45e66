#include <explore/memory/door_belief.h>
#include <explore/memory/door_sighting.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kLeastSure = 0.02;  // no look is surer than 0.98 or less sure than this
/** A report with a jamb out of view does not know what the door is. */
constexpr double kPartialWeight = 0.1;
constexpr double kSharedError = 0.5;

std::size_t indexOf(Verdict verdict)
{
	return static_cast<std::size_t>(verdict);
}

/** How surely the look says what it says: P(pass) for what can be passed, the opposite for the rest; never nothing. */
double conviction(const DoorOpinion& opinion)
{
	constexpr double kLeast = 0.3;
	if (opinion.verdict == Verdict::partial) return kPartialWeight;
	return std::max(isPassable(opinion.verdict) ? opinion.confidence : 1 - opinion.confidence, kLeast);
}

/** The mean of two values by their weights; 0 without weight. */
double meanOf(double a, double weight_a, double b, double weight_b)
{
	const double weight = weight_a + weight_b;
	return weight > 0 ? (weight_a * a + weight_b * b) / weight : 0.0;
}

DoorBelief::Said together(const DoorBelief::Said& a, const DoorBelief::Said& b)
{
	return {a.weight + b.weight, meanOf(a.clear_width_m, a.weight, b.clear_width_m, b.weight)};
}

double weightOf(const DoorBelief& belief, bool passable)
{
	double weight = 0;
	for (std::size_t i = 0; i < belief.said.size(); ++i)
		if (isPassable(static_cast<Verdict>(i)) == passable) weight += belief.said[i].weight;
	return weight;
}
}  // namespace

void addOpinion(DoorBelief& belief, const DoorOpinion& opinion, double fading)
{
	const double kept = std::pow(fading, opinion.weight);
	for (DoorBelief::Said& said : belief.said) said.weight *= kept;
	belief.weight *= kept;

	const double weight = opinion.weight * conviction(opinion);
	DoorBelief::Said& said = belief.said[indexOf(opinion.verdict)];
	said = together(said, {weight, opinion.clear_width_m});

	const double informed = opinion.verdict == Verdict::partial ? kPartialWeight * opinion.weight : opinion.weight;
	const double sure = std::clamp(opinion.confidence, kLeastSure, 1 - kLeastSure);
	belief.log_odds = meanOf(belief.log_odds, belief.weight, logOdds(sure), informed);
	belief.weight += informed;
}

Verdict verdictOf(const DoorBelief& belief)
{
	const bool passable = weightOf(belief, true) > weightOf(belief, false);
	Verdict best = Verdict::unknown;
	double most = 0;
	for (std::size_t i = 0; i < belief.said.size(); ++i)
	{
		const auto verdict = static_cast<Verdict>(i);
		if (isPassable(verdict) != passable || belief.said[i].weight <= most) continue;
		best = verdict;
		most = belief.said[i].weight;
	}
	return best;
}

double clearWidthOf(const DoorBelief& belief)
{
	return belief.said[indexOf(verdictOf(belief))].clear_width_m;
}

double confidenceOf(const DoorBelief& belief)
{
	const double looks = std::max(belief.weight, 1.0);
	return probabilityOf(belief.log_odds * looks / (1 + (looks - 1) * kSharedError));
}

DoorBelief joined(const DoorBelief& a, const DoorBelief& b)
{
	DoorBelief result;
	for (std::size_t i = 0; i < result.said.size(); ++i) result.said[i] = together(a.said[i], b.said[i]);
	result.weight = a.weight + b.weight;
	result.log_odds = meanOf(a.log_odds, a.weight, b.log_odds, b.weight);
	return result;
}
}  // namespace explore
