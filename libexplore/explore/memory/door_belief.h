// What all looks at a door together say about it: its verdict, its clear width, and whether the robot can pass.
#pragma once

#include <explore/core/results.h>

#include <array>
#include <optional>

namespace explore
{
/** Looks fade, so that a door that is opened or closed is believed after some looks, but not after one. */
struct DoorBelief
{
	static constexpr std::size_t kVerdicts = 8;
	struct Said
	{
		double weight = 0;         ///< of the looks that said so, faded
		double clear_width_m = 0;  ///< their weighted mean
	};
	std::array<Said, kVerdicts> said;  ///< by Verdict
	double weight = 0;                 ///< of all looks, faded
	double log_odds = 0;               ///< weighted mean of ln(P(pass) / (1 − P(pass)))
};

/** What one look says. */
struct DoorOpinion
{
	Verdict verdict = Verdict::open;
	double clear_width_m = 0;
	double confidence = 0.5;  ///< P(the robot can pass)
	double weight = 1;        ///< 0–1 for a look; more for what tells more than one
};
/** `fading` is what remains of the weight of earlier looks when a look of weight 1 comes, 0–1. */
void addOpinion(DoorBelief& belief, const DoorOpinion& opinion, double fading);

/** The verdict with the most weight, of those that can be passed or of those that cannot, whichever have more together.
 *  No look yet: unknown. */
[[nodiscard]] Verdict verdictOf(const DoorBelief& belief);
/** As the looks with that verdict have it [m]. */
[[nodiscard]] double clearWidthOf(const DoorBelief& belief);
/** P(the robot can pass). Looks at one door share half of their error, so that many are worth two independent ones. */
[[nodiscard]] double confidenceOf(const DoorBelief& belief);

/** That of two tracks that are the same door. */
[[nodiscard]] DoorBelief joined(const DoorBelief& a, const DoorBelief& b);
}  // namespace explore
