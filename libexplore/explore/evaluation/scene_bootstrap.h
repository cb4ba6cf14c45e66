// Intervals of figures that are no plain rates (medians, calibration), by resampling whole scenes.
#pragma once

#include <explore/evaluation/statistics.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace explore::evaluation
{
/** How often each scene was drawn. */
using SceneWeights = std::vector<std::uint32_t>;

struct Interval
{
	double low = 0, high = 0;
};

/** A figure of a resample; no value where that has no case. */
using SceneStatistic = std::function<std::optional<double>(const SceneWeights&)>;

/** The 95 % interval of each statistic (percentiles 2.5 and 97.5 of 1000 resamples of `scenes` scenes, fixed seed, the
 *  same resamples for all); no value where none of them has one. */
std::vector<std::optional<Interval>> bootstrapIntervals(std::size_t scenes, std::span<const SceneStatistic> statistics);

/** Values by the scene that they were measured in. */
class SceneValues
{
public:
	void add(double value, std::size_t scene) { m_values.push_back({value, static_cast<std::uint32_t>(scene)}); }
	/** Must come before quantile(). */
	void sort();
	[[nodiscard]] bool empty() const { return m_values.empty(); }
	/** As quantile() of each value as often as its scene was drawn. */
	[[nodiscard]] std::optional<double> quantile(const SceneWeights& weights, double share) const;

private:
	struct Value
	{
		double value;
		std::uint32_t scene;
	};
	std::vector<Value> m_values;
};

/** Candidates by the scene that they were reported in. */
class SceneCandidates
{
public:
	void add(const Candidate& candidate, std::size_t scene)
	{
		m_candidates.push_back({candidate, static_cast<std::uint32_t>(scene)});
	}
	/** Must come before the figures. */
	void sort();
	[[nodiscard]] bool empty() const { return m_candidates.empty(); }
	/** As calibrationError() and auroc() of each candidate as often as its scene was drawn. */
	[[nodiscard]] std::optional<double> calibrationErrorOf(const SceneWeights& weights) const;
	[[nodiscard]] std::optional<double> aurocOf(const SceneWeights& weights) const;

private:
	[[nodiscard]] std::vector<EqualCandidates> weighted(const SceneWeights& weights) const;

	struct Placed
	{
		Candidate candidate;
		std::uint32_t scene;
	};
	std::vector<Placed> m_candidates;
};
}  // namespace explore::evaluation
