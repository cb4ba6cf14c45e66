#include "support/fit_trees.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace explore::test
{
namespace
{
constexpr double kPerLogit = 1000.0;

/** Gradient and curvature of the logistic loss over some samples. */
struct Slope
{
	double gradient = 0, curvature = 0, samples = 0;

	Slope& operator+=(const Slope& other)
	{
		gradient += other.gradient;
		curvature += other.curvature;
		samples += other.samples;
		return *this;
	}
	Slope operator-(const Slope& other) const
	{
		return {gradient - other.gradient, curvature - other.curvature, samples - other.samples};
	}
	[[nodiscard]] double gain(const TreeFitConfig& config) const
	{
		return gradient * gradient / (curvature + 0.25 * config.prior);
	}
	[[nodiscard]] double vote(const TreeFitConfig& config) const
	{
		return -config.rate * gradient / (curvature + 0.25 * config.prior);
	}
};

/** The features of all samples as the number of thresholds that each is greater than. */
class Binned
{
public:
	Binned(const std::vector<KnownOpening>& openings, int thresholds) : m_bins(kOpeningFeatures * openings.size())
	{
		for (std::size_t f = 0; f < kOpeningFeatures; ++f)
		{
			m_thresholds.push_back(quantiles(openings, f, thresholds));
			for (std::size_t i = 0; i < openings.size(); ++i)
				m_bins[f * openings.size() + i] = static_cast<std::uint8_t>(
				    std::ranges::lower_bound(m_thresholds[f], openings[i].features.at(f)) - m_thresholds[f].begin());
		}
		m_samples = openings.size();
	}
	[[nodiscard]] const std::vector<float>& thresholds(std::size_t feature) const { return m_thresholds[feature]; }
	[[nodiscard]] const std::uint8_t* bins(std::size_t feature) const { return &m_bins[feature * m_samples]; }

private:
	static std::vector<float> quantiles(const std::vector<KnownOpening>& openings, std::size_t feature, int count)
	{
		std::vector<float> values, chosen;
		values.reserve(openings.size());
		for (const KnownOpening& opening : openings) values.push_back(opening.features.at(feature));
		std::ranges::sort(values);
		// Each value counts once: of many a feature, most openings have the same.
		values.erase(std::unique(values.begin(), values.end()), values.end());
		for (int q = 1; q <= count; ++q)
		{
			const std::size_t at = values.size() * static_cast<std::size_t>(q) / static_cast<std::size_t>(count + 1);
			const auto next = std::ranges::upper_bound(values, values[at]);
			if (next == values.end()) break;
			// Between two values that occur, and short enough to be written down exactly.
			const float middle = std::round(5000.0F * (values[at] + *next)) / 10000.0F;
			if (middle >= values[at] && middle < *next && (chosen.empty() || middle > chosen.back()))
				chosen.push_back(middle);
		}
		return chosen;
	}

	std::size_t m_samples = 0;
	std::vector<std::vector<float>> m_thresholds;
	std::vector<std::uint8_t> m_bins;
};

struct Question
{
	std::size_t feature = 0, threshold = 0;
	double gain = 0;
};

/** The openings that reach a node, and the question that parts them best. */
struct Leaf
{
	std::size_t node = 0;
	std::vector<std::uint32_t> openings;
	Slope slope;
	Question question;
};

void ask(Leaf& leaf, const Binned& binned, const std::vector<Slope>& slopes, const TreeFitConfig& config)
{
	leaf.slope = {};
	for (const std::uint32_t i : leaf.openings) leaf.slope += slopes[i];
	leaf.question = {};
	std::vector<Slope> sums;
	for (std::size_t f = 0; f < kOpeningFeatures; ++f)
	{
		sums.assign(binned.thresholds(f).size() + 1, Slope{});
		const std::uint8_t* bin = binned.bins(f);
		for (const std::uint32_t i : leaf.openings) sums[bin[i]] += slopes[i];
		Slope below;
		for (std::size_t t = 0; t + 1 < sums.size(); ++t)
		{
			below += sums[t];
			const Slope above = leaf.slope - below;
			if (std::min(below.samples, above.samples) < config.min_samples) continue;
			const double gain = below.gain(config) + above.gain(config) - leaf.slope.gain(config);
			if (gain > leaf.question.gain) leaf.question = {f, t, gain};
		}
	}
}

/** Grows a tree and adds its votes to `logit`. */
PassTree fitTree(const Binned& binned, const std::vector<Slope>& slopes, const TreeFitConfig& config,
                 std::vector<double>& logit)
{
	PassTree tree{};
	std::vector<Leaf> leaves(1);
	leaves[0].openings.resize(slopes.size());
	std::iota(leaves[0].openings.begin(), leaves[0].openings.end(), 0U);
	ask(leaves[0], binned, slopes, config);
	for (std::size_t used = 1; used + 2 <= tree.size(); used += 2)
	{
		const auto best = std::ranges::max_element(leaves, {}, [](const Leaf& leaf) { return leaf.question.gain; });
		if (best->question.gain <= 0.0) break;
		const Question question = best->question;
		tree.at(best->node) = {static_cast<std::int8_t>(question.feature),
		                       binned.thresholds(question.feature)[question.threshold],
		                       static_cast<std::int16_t>(used)};
		Leaf no, yes;
		no.node = used;
		yes.node = used + 1;
		const std::uint8_t* bin = binned.bins(question.feature);
		for (const std::uint32_t i : best->openings) (bin[i] > question.threshold ? yes : no).openings.push_back(i);
		ask(no, binned, slopes, config);
		ask(yes, binned, slopes, config);
		*best = std::move(no);
		leaves.push_back(std::move(yes));
	}
	for (const Leaf& leaf : leaves)
	{
		const auto vote = static_cast<std::int16_t>(std::lround(kPerLogit * leaf.slope.vote(config)));
		tree.at(leaf.node) = {-1, 0.0F, vote};
		for (const std::uint32_t i : leaf.openings) logit[i] += vote / kPerLogit;
	}
	return tree;
}
}  // namespace

std::vector<PassTree> fitTrees(const std::vector<KnownOpening>& openings, const TreeFitConfig& config)
{
	const Binned binned(openings, config.thresholds);
	std::vector<double> logit(openings.size(), 0.0);
	std::vector<Slope> slopes(openings.size());
	std::vector<PassTree> trees;
	trees.reserve(static_cast<std::size_t>(config.trees));
	for (int round = 0; round < config.trees; ++round)
	{
		for (std::size_t i = 0; i < openings.size(); ++i)
		{
			const double p = 1.0 / (1.0 + std::exp(-logit[i]));
			slopes[i] = {p - (openings[i].passable ? 1.0 : 0.0), p * (1.0 - p), 1.0};
		}
		trees.push_back(fitTree(binned, slopes, config, logit));
	}
	return trees;
}
}  // namespace explore::test
