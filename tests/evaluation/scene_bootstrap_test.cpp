#include <explore/evaluation/scene_bootstrap.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace explore::evaluation;

namespace
{
/** Samples of random scenes, and the same with each sample written out as often as its scene was drawn. */
struct RandomCase
{
	SceneWeights weights;
	SceneValues values;
	SceneCandidates candidates;
	std::vector<double> all_values;
	std::vector<Candidate> all_candidates;

	explicit RandomCase(std::uint64_t seed)
	{
		std::mt19937_64 random(seed);
		for (std::size_t scene = 0; scene < 12; ++scene)
		{
			weights.push_back(static_cast<std::uint32_t>(random() % 4));
			for (std::uint64_t i = random() % 4; i > 0; --i)
			{
				const double value = static_cast<double>(random() % 20) / 20.0;
				const Candidate candidate{static_cast<double>(random() % 8) / 8.0, random() % 2 == 0};
				values.add(value, scene);
				candidates.add(candidate, scene);
				for (std::uint32_t copy = 0; copy < weights[scene]; ++copy)
				{
					all_values.push_back(value);
					all_candidates.push_back(candidate);
				}
			}
		}
		values.sort();
		candidates.sort();
	}
};

void expectNear(const std::optional<double>& a, const std::optional<double>& b, std::uint64_t seed)
{
	ASSERT_EQ(a.has_value(), b.has_value()) << seed;
	EXPECT_NEAR(a.value_or(0.0), b.value_or(0.0), 1e-12) << seed;
}
}  // namespace

TEST(SceneBootstrap, WeightsAreCopies)
{
	for (std::uint64_t seed = 0; seed < 300; ++seed)
	{
		const RandomCase c(seed);
		for (const double share : {0.025, 0.5, 0.99})
			expectNear(c.values.quantile(c.weights, share), quantile(c.all_values, share), seed);
		expectNear(c.candidates.aurocOf(c.weights), auroc(byConfidence(c.all_candidates)), seed);
		expectNear(c.candidates.calibrationErrorOf(c.weights), calibrationError(byConfidence(c.all_candidates)), seed);
	}
}

TEST(SceneBootstrap, ReliabilityBinsHoldEqualCountsAndAllCandidates)
{
	for (std::uint64_t seed = 0; seed < 50; ++seed)
	{
		std::mt19937_64 random(seed);
		std::vector<Candidate> candidates;
		const std::size_t size = 15 + random() % 200;
		double right = 0, confidence = 0;
		for (std::size_t i = 0; i < size; ++i)
		{
			candidates.push_back({static_cast<double>(random() % 30) / 30.0, random() % 3 > 0});
			right += candidates.back().right ? 1.0 : 0.0;
			confidence += candidates.back().confidence;
		}
		const auto bins = reliability(byConfidence(candidates));
		ASSERT_EQ(bins.size(), 15U);
		double rights = 0, confidences = 0, last = 0;
		for (const ReliabilityBin& bin : bins)
		{
			EXPECT_NEAR(static_cast<double>(bin.count), static_cast<double>(size) / 15.0, 1.0);
			EXPECT_LE(last, bin.lowest);
			EXPECT_LE(bin.lowest, bin.confidence + 1e-12);
			EXPECT_LE(bin.confidence, bin.highest + 1e-12);
			last = bin.highest;
			rights += bin.right * static_cast<double>(bin.count);
			confidences += bin.confidence * static_cast<double>(bin.count);
		}
		EXPECT_NEAR(rights, right, 1e-9);
		EXPECT_NEAR(confidences, confidence, 1e-9);
	}
}

/** A statistic that is a rate has the interval that rateOf() gives it. */
TEST(SceneBootstrap, AgreesWithTheIntervalOfARate)
{
	std::mt19937_64 random(8);
	std::vector<SceneRatio> scenes;
	for (int i = 0; i < 150; ++i) scenes.push_back({random() % 3, 2});
	const std::vector<SceneStatistic> statistics{[&](const SceneWeights& weights) -> std::optional<double>
	                                             {
		                                             double good = 0, all = 0;
		                                             for (std::size_t i = 0; i < scenes.size(); ++i)
		                                             {
			                                             good += static_cast<double>(weights[i] * scenes[i].good);
			                                             all += static_cast<double>(weights[i] * scenes[i].all);
		                                             }
		                                             return good / all;
	                                             },
	                                             [](const SceneWeights&) { return std::nullopt; }};
	const auto intervals = bootstrapIntervals(scenes.size(), statistics);
	const auto rate = rateOf(scenes);
	ASSERT_EQ(intervals.size(), 2U);
	EXPECT_DOUBLE_EQ(intervals[0]->low, rate->low);
	EXPECT_DOUBLE_EQ(intervals[0]->high, rate->high);
	EXPECT_FALSE(intervals[1]);
}
