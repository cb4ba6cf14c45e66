// Figures from samples and counts: quantiles, rates with bootstrap intervals over scenes, calibration.
#pragma once

#include <explore/evaluation/tally.h>

#include <optional>
#include <span>
#include <vector>

namespace explore::evaluation
{
/** The smallest value that at least this share of the values does not exceed (nearest rank); no value for none. */
std::optional<double> quantile(std::vector<double> values, double share);

/** Of every bootstrap: resamples of the scenes, and the seed that they are drawn with. */
inline constexpr std::size_t kResamples = 1000;
inline constexpr std::uint64_t kBootstrapSeed = 20150612;

/** `good` of `all`, in one scene. */
struct SceneRatio
{
	Count good = 0, all = 0;
};

/** A rate with its 95 % interval. */
struct Rate
{
	double value = 0, low = 0, high = 0;
	Count good = 0, all = 0;
};

/** Sum of good by sum of all; the interval from 1000 resamples of whole scenes with a fixed seed (percentiles 2.5 and
 *  97.5). Where no scene differs from a rate of 0 or 1, resampling says nothing, and the far end of the interval is
 * that of Clopper and Pearson over scenes: 0.025^(1/n) for a rate of 1. No value where `all` is 0 everywhere. */
std::optional<Rate> rateOf(std::span<const SceneRatio> scenes);

/** Candidates of one confidence. */
struct EqualCandidates
{
	double confidence = 0;
	Count count = 0, right = 0;
};
/** By rising confidence. */
std::vector<EqualCandidates> byConfidence(std::vector<Candidate> candidates);

/** Share of pairs (one right, one wrong) that the confidence puts in order, ties half; no value without both kinds. */
std::optional<double> auroc(std::span<const EqualCandidates> candidates);

/** One bin of a reliability diagram. Candidates of equal confidence count with their common share of right ones. */
struct ReliabilityBin
{
	double lowest = 0, highest = 0;  ///< confidences
	Count count = 0;
	double confidence = 0, right = 0;  ///< mean confidence; share of right ones
};
/** Up to 15 bins of equal count, lowest confidences first. `candidates` by rising confidence. */
std::vector<ReliabilityBin> reliability(std::span<const EqualCandidates> candidates);

/** Expected calibration error: the mean over the candidates of their bin's |confidence − right|; no value without
 *  candidates. */
std::optional<double> calibrationError(std::span<const EqualCandidates> candidates);

struct CurvePoint
{
	double threshold = 0, precision = 0, recall = 0;
};
/** One point a distinct confidence, from the highest down; at most `most` of them, evenly chosen, ends included.
 *  `positives` is the number of doors to be found. */
std::vector<CurvePoint> precisionRecall(std::vector<Candidate> candidates, Count positives, std::size_t most);
}  // namespace explore::evaluation
