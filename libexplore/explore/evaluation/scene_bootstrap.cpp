#include <explore/evaluation/scene_bootstrap.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace explore::evaluation
{
namespace
{
constexpr double kCutOff = 0.025;

void drawScenes(std::mt19937_64& random, SceneWeights& weights)
{
	std::ranges::fill(weights, 0U);
	for (std::size_t i = 0; i < weights.size(); ++i) ++weights[random() % weights.size()];
}
}  // namespace

std::vector<std::optional<Interval>> bootstrapIntervals(std::size_t scenes, std::span<const SceneStatistic> statistics)
{
	std::mt19937_64 random(kBootstrapSeed);
	SceneWeights weights(scenes, 0);
	std::vector<std::vector<double>> drawn(statistics.size());
	for (std::size_t i = 0; i < kResamples && scenes > 0; ++i)
	{
		drawScenes(random, weights);
		for (std::size_t j = 0; j < statistics.size(); ++j)
			if (const auto value = statistics[j](weights)) drawn[j].push_back(*value);
	}
	std::vector<std::optional<Interval>> intervals;
	intervals.reserve(drawn.size());
	for (const auto& values : drawn)
	{
		const auto low = quantile(values, kCutOff), high = quantile(values, 1.0 - kCutOff);
		intervals.push_back(low && high ? std::optional(Interval{*low, *high}) : std::nullopt);
	}
	return intervals;
}

void SceneValues::sort()
{
	std::ranges::stable_sort(m_values, {}, &Value::value);
}

std::optional<double> SceneValues::quantile(const SceneWeights& weights, double share) const
{
	std::uint64_t total = 0;
	for (const Value& value : m_values) total += weights[value.scene];
	if (total == 0) return std::nullopt;
	const auto rank =
	    std::clamp<std::uint64_t>(static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(total))), 1, total);
	std::uint64_t passed = 0;
	for (const Value& value : m_values)
		if ((passed += weights[value.scene]) >= rank) return value.value;
	return m_values.back().value;
}

void SceneCandidates::sort()
{
	std::ranges::stable_sort(m_candidates, {}, [](const Placed& placed) { return placed.candidate.confidence; });
}

std::vector<EqualCandidates> SceneCandidates::weighted(const SceneWeights& weights) const
{
	std::vector<EqualCandidates> groups;
	groups.reserve(m_candidates.size());
	for (const Placed& placed : m_candidates)
	{
		const Count weight = weights[placed.scene];
		if (weight == 0) continue;
		if (groups.empty() || groups.back().confidence != placed.candidate.confidence)
			groups.push_back({placed.candidate.confidence, 0, 0});
		groups.back().count += weight;
		if (placed.candidate.right) groups.back().right += weight;
	}
	return groups;
}

std::optional<double> SceneCandidates::calibrationErrorOf(const SceneWeights& weights) const
{
	return calibrationError(weighted(weights));
}

std::optional<double> SceneCandidates::aurocOf(const SceneWeights& weights) const
{
	return auroc(weighted(weights));
}
}  // namespace explore::evaluation
