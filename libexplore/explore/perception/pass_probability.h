// How likely a robot can pass an opening, from the row of what is known about it.
#pragma once

#include <explore/perception/opening_features.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace explore
{
/** A question of a tree, or the vote at its end. */
struct PassNode
{
	std::int8_t feature = -1;  ///< is this one of openingFeatures() greater than `threshold`? −1: no question, a vote
	float threshold = 0;
	std::int16_t next = 0;  ///< the node to go on with on no, the one behind it on yes; or the vote [1/1000 logit]
};

inline constexpr std::size_t kPassTreeNodes = 31;
using PassTree = std::array<PassNode, kPassTreeNodes>;  ///< the first node is the root

/** Regression trees boosted one after the other (Friedman 2001), fitted by tests/support's fit_openings to openings
 * whose truth is known; doc/method.md tells to which. */
std::span<const PassTree> passTrees();

/** P(the robot can pass now), 0–1, by these trees. */
double passProbability(const OpeningFeatures& features, std::span<const PassTree> trees = passTrees());
}  // namespace explore
