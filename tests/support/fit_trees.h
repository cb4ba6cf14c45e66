// Fits the boosted trees that turn what is known about an opening into a probability.
#pragma once

#include <explore/perception/pass_probability.h>

#include <vector>

namespace explore::test
{
/** An opening whose truth is known. */
struct KnownOpening
{
	OpeningFeatures features{};
	bool passable = false;
};

struct TreeFitConfig
{
	int trees = 120;
	double rate = 0.15;       ///< share of the best votes that each tree gives
	double prior = 8.0;       ///< samples' worth of doubt in each vote
	double min_samples = 20;  ///< a vote that fewer would decide is none
	int thresholds = 250;     ///< tried for each feature: quantiles
};

/** Gradient boosting of the logistic loss. Trees grow question by question: the next one is that which, over all
 * leaves, features and thresholds, lowers the loss most. Deterministic. */
std::vector<PassTree> fitTrees(const std::vector<KnownOpening>& openings, const TreeFitConfig& config);
}  // namespace explore::test
