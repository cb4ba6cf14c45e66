#include <explore/evaluation/statistics.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <ranges>

namespace explore::evaluation
{
namespace
{
constexpr double kTail = 0.025;

SceneRatio sumOf(std::span<const SceneRatio> scenes)
{
	SceneRatio sum;
	for (const SceneRatio& scene : scenes)
	{
		sum.good += scene.good;
		sum.all += scene.all;
	}
	return sum;
}

double shareOf(const SceneRatio& ratio)
{
	return static_cast<double>(ratio.good) / static_cast<double>(ratio.all);
}

/** The rates of resamples of the scenes; those without any case are drawn but say nothing. */
std::vector<double> resampled(const std::vector<SceneRatio>& scenes)
{
	std::mt19937_64 random(kBootstrapSeed);
	std::vector<double> rates;
	rates.reserve(kResamples);
	for (std::size_t i = 0; i < kResamples; ++i)
	{
		SceneRatio sum;
		for (std::size_t j = 0; j < scenes.size(); ++j)
		{
			const SceneRatio& scene = scenes[random() % scenes.size()];
			sum.good += scene.good;
			sum.all += scene.all;
		}
		if (sum.all > 0) rates.push_back(shareOf(sum));
	}
	return rates;
}

/** Highest confidence first. */
void sortDown(std::vector<Candidate>& candidates)
{
	std::ranges::stable_sort(
	    candidates, [](const Candidate& a, const Candidate& b)
	    { return a.confidence != b.confidence ? a.confidence > b.confidence : a.right > b.right; });
}
}  // namespace

std::optional<double> quantile(std::vector<double> values, double share)
{
	if (values.empty()) return std::nullopt;
	std::ranges::sort(values);
	const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
	return values[std::clamp<std::size_t>(rank, 1, values.size()) - 1];
}

std::optional<Rate> rateOf(std::span<const SceneRatio> scenes)
{
	std::vector<SceneRatio> used;
	std::ranges::copy_if(scenes, std::back_inserter(used), [](const SceneRatio& scene) { return scene.all > 0; });
	if (used.empty()) return std::nullopt;
	const SceneRatio sum = sumOf(used);
	Rate rate{shareOf(sum), 0, 0, sum.good, sum.all};
	const double certain = std::pow(kTail, 1.0 / static_cast<double>(used.size()));
	if (sum.good == sum.all)
		rate.low = certain, rate.high = 1.0;
	else if (sum.good == 0)
		rate.low = 0.0, rate.high = 1.0 - certain;
	else
	{
		const auto rates = resampled(used);
		rate.low = *quantile(rates, kTail);
		rate.high = *quantile(rates, 1.0 - kTail);
	}
	return rate;
}

std::vector<EqualCandidates> byConfidence(std::vector<Candidate> candidates)
{
	sortDown(candidates);
	std::vector<EqualCandidates> groups;
	for (const Candidate& candidate : std::views::reverse(candidates))
	{
		if (groups.empty() || groups.back().confidence != candidate.confidence)
			groups.push_back({candidate.confidence, 0, 0});
		++groups.back().count;
		if (candidate.right) ++groups.back().right;
	}
	return groups;
}

std::optional<double> auroc(std::span<const EqualCandidates> candidates)
{
	double ordered = 0.0, wrong = 0.0, right = 0.0;  // of those passed, which have lower confidences
	for (const EqualCandidates& group : candidates)
	{
		const auto tied_right = static_cast<double>(group.right);
		const auto tied_wrong = static_cast<double>(group.count - group.right);
		ordered += tied_right * (wrong + 0.5 * tied_wrong);
		right += tied_right;
		wrong += tied_wrong;
	}
	if (right == 0.0 || wrong == 0.0) return std::nullopt;
	return ordered / (right * wrong);
}

std::vector<ReliabilityBin> reliability(std::span<const EqualCandidates> candidates)
{
	constexpr Count kBins = 15;
	Count total = 0, passed = 0;
	for (const EqualCandidates& group : candidates) total += group.count;
	std::vector<ReliabilityBin> bins;
	auto group = candidates.begin();
	Count left = candidates.empty() ? 0 : group->count;  // of the group
	for (Count index = 1; index <= kBins; ++index)
	{
		const Count end = index * total / kBins;
		if (end == passed) continue;
		ReliabilityBin bin{group->confidence, group->confidence, end - passed, 0.0, 0.0};
		while (passed < end)
		{
			const Count taken = std::min(left, end - passed);
			const double share = static_cast<double>(taken) / static_cast<double>(bin.count);
			bin.highest = group->confidence;
			bin.confidence += share * group->confidence;
			bin.right += share * static_cast<double>(group->right) / static_cast<double>(group->count);
			passed += taken;
			left -= taken;
			if (left == 0 && ++group != candidates.end()) left = group->count;
		}
		bins.push_back(bin);
	}
	return bins;
}

std::optional<double> calibrationError(std::span<const EqualCandidates> candidates)
{
	double error = 0.0, total = 0.0;
	for (const ReliabilityBin& bin : reliability(candidates))
	{
		const auto count = static_cast<double>(bin.count);
		error += count * std::abs(bin.confidence - bin.right);
		total += count;
	}
	return total > 0.0 ? std::optional(error / total) : std::nullopt;
}

std::vector<CurvePoint> precisionRecall(std::vector<Candidate> candidates, Count positives, std::size_t most)
{
	sortDown(candidates);
	std::vector<CurvePoint> points;
	double right = 0.0;
	for (std::size_t i = 0; i < candidates.size(); ++i)
	{
		right += candidates[i].right ? 1.0 : 0.0;
		if (i + 1 < candidates.size() && candidates[i + 1].confidence == candidates[i].confidence) continue;
		points.push_back({candidates[i].confidence, right / static_cast<double>(i + 1),
		                  positives > 0 ? right / static_cast<double>(positives) : 0.0});
	}
	if (points.size() <= most || most < 2) return points;
	std::vector<CurvePoint> chosen;
	for (std::size_t i = 0; i < most; ++i) chosen.push_back(points[i * (points.size() - 1) / (most - 1)]);
	return chosen;
}
}  // namespace explore::evaluation
