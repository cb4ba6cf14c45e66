#include <explore/evaluation/statistics.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace explore::evaluation
{
namespace
{
constexpr std::size_t kResamples = 1000;
constexpr std::uint64_t kSeed = 20150612;
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
	std::mt19937_64 random(kSeed);
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
/** For each candidate the share of right ones among those of its confidence: no order among equals can sway a bin. */
std::vector<double> rightShares(const std::vector<Candidate>& sorted)
{
	std::vector<double> shares;
	while (shares.size() < sorted.size())
	{
		const auto first = sorted.begin() + static_cast<std::ptrdiff_t>(shares.size());
		const auto last = std::find_if(
		    first, sorted.end(), [&](const Candidate& candidate) { return candidate.confidence != first->confidence; });
		const auto right = static_cast<double>(std::count_if(first, last, [](const Candidate& c) { return c.right; }));
		shares.insert(shares.end(), static_cast<std::size_t>(last - first), right / static_cast<double>(last - first));
	}
	return shares;
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

std::optional<double> auroc(std::vector<Candidate> candidates)
{
	sortDown(candidates);
	double ordered = 0.0, right_above = 0.0, wrong = 0.0, right = 0.0;
	for (std::size_t i = 0; i < candidates.size();)
	{
		double tied_right = 0.0, tied_wrong = 0.0;
		const double confidence = candidates[i].confidence;
		for (; i < candidates.size() && candidates[i].confidence == confidence; ++i)
			(candidates[i].right ? tied_right : tied_wrong) += 1.0;
		ordered += tied_wrong * (right_above + 0.5 * tied_right);
		right_above += tied_right;
		right += tied_right;
		wrong += tied_wrong;
	}
	if (right == 0.0 || wrong == 0.0) return std::nullopt;
	return ordered / (right * wrong);
}

std::optional<double> calibrationError(std::vector<Candidate> candidates)
{
	constexpr std::size_t kBins = 15;
	if (candidates.empty()) return std::nullopt;
	sortDown(candidates);
	std::ranges::reverse(candidates);
	const std::vector<double> right = rightShares(candidates);
	double error = 0.0;
	const std::size_t count = candidates.size();
	for (std::size_t bin = 0; bin < kBins; ++bin)
	{
		double gap = 0.0;
		for (std::size_t i = bin * count / kBins; i < (bin + 1) * count / kBins; ++i)
			gap += candidates[i].confidence - right[i];
		error += std::abs(gap);  // the bin's gap times its number of candidates
	}
	return error / static_cast<double>(count);
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
