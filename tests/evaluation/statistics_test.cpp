#include <explore/evaluation/statistics.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace explore::evaluation;

namespace
{
double uniform(std::mt19937_64& random)
{
	return static_cast<double>(random() >> 11U) * 0x1.0p-53;
}
}  // namespace

TEST(Statistics, QuantilesAreNearestRanks)
{
	EXPECT_EQ(quantile({}, 0.5), std::nullopt);
	EXPECT_EQ(quantile({3.0}, 0.99), 3.0);
	EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2.0);
	EXPECT_EQ(quantile({4, 1, 3, 2, 5}, 0.5), 3.0);
	std::vector<double> hundred;
	for (int i = 100; i > 0; --i) hundred.push_back(i);
	EXPECT_EQ(quantile(hundred, 0.99), 99.0);
	EXPECT_EQ(quantile(hundred, 0.0), 1.0);
	EXPECT_EQ(quantile(hundred, 1.0), 100.0);
}

TEST(Statistics, RatesAreSumsOverScenesNotMeans)
{
	const std::vector<SceneRatio> scenes{{1, 1}, {0, 9}, {0, 0}};
	const auto rate = rateOf(scenes);
	ASSERT_TRUE(rate);
	EXPECT_DOUBLE_EQ(rate->value, 0.1);
	EXPECT_EQ(rate->good, 1U);
	EXPECT_EQ(rate->all, 10U);
	EXPECT_FALSE(rateOf(std::vector<SceneRatio>{{0, 0}}));
	EXPECT_FALSE(rateOf({}));
}

TEST(Statistics, ACertainRateHasTheIntervalOfClopperAndPearson)
{
	const auto all = rateOf(std::vector<SceneRatio>(500, {2, 2}));
	EXPECT_DOUBLE_EQ(all->low, std::pow(0.025, 1.0 / 500));
	EXPECT_EQ(all->high, 1.0);
	const auto none = rateOf(std::vector<SceneRatio>(20, {0, 3}));
	EXPECT_EQ(none->low, 0.0);
	EXPECT_DOUBLE_EQ(none->high, 1.0 - std::pow(0.025, 1.0 / 20));
}

TEST(Statistics, IntervalsAreTheSameEveryTime)
{
	const std::vector<SceneRatio> scenes{{1, 2}, {3, 3}, {0, 1}, {2, 4}, {5, 5}};
	EXPECT_EQ(rateOf(scenes)->low, rateOf(scenes)->low);
	EXPECT_EQ(rateOf(scenes)->high, rateOf(scenes)->high);
	EXPECT_LT(rateOf(scenes)->low, rateOf(scenes)->value);
	EXPECT_GT(rateOf(scenes)->high, rateOf(scenes)->value);
}

/** A 95 % interval holds the true rate in about 95 of 100 experiments. */
TEST(Statistics, IntervalsCoverTheTrueRateOfABinomial)
{
	constexpr double kTrue = 0.85;
	constexpr int kExperiments = 300;
	std::mt19937_64 random(3);
	int covered = 0;
	for (int i = 0; i < kExperiments; ++i)
	{
		std::vector<SceneRatio> scenes(120);
		for (SceneRatio& scene : scenes) scene = {uniform(random) < kTrue ? 1U : 0U, 1};
		const auto rate = rateOf(scenes);
		covered += rate->low <= kTrue && kTrue <= rate->high ? 1 : 0;
	}
	// Three standard deviations of the count around 95 %, and what the percentile method lacks.
	EXPECT_GE(covered, 0.95 * kExperiments - 3 * std::sqrt(0.05 * 0.95 * kExperiments) - 0.01 * kExperiments);
	EXPECT_LE(covered, 0.95 * kExperiments + 3 * std::sqrt(0.05 * 0.95 * kExperiments));
}

/** Frames of one scene fail together: an interval over scenes must be wide, one over frames would not be. */
TEST(Statistics, IntervalsAreOverScenesNotFrames)
{
	std::vector<SceneRatio> scenes(40, {20, 20});
	for (std::size_t i = 0; i < 8; ++i) scenes[i].good = 0;
	const auto rate = rateOf(scenes);
	EXPECT_DOUBLE_EQ(rate->value, 0.8);
	// Binomial over 40: ±1.96 √(0.8·0.2/40) = ±0.124; over 800 frames it would be ±0.028.
	EXPECT_NEAR(rate->high - rate->low, 0.248, 0.05);
}

TEST(Statistics, AurocIsTheShareOfOrderedPairs)
{
	std::mt19937_64 random(9);
	for (int round = 0; round < 50; ++round)
	{
		std::vector<Candidate> candidates;
		for (int i = 0; i < 60; ++i)
			candidates.push_back({static_cast<double>(random() % 10) / 10.0, random() % 3 == 0});
		double ordered = 0, pairs = 0;
		for (const Candidate& right : candidates)
			for (const Candidate& wrong : candidates)
			{
				if (!right.right || wrong.right) continue;
				pairs += 1;
				ordered += right.confidence > wrong.confidence ? 1.0 : right.confidence == wrong.confidence ? 0.5 : 0.0;
			}
		ASSERT_GT(pairs, 0);
		EXPECT_NEAR(*auroc(byConfidence(candidates)), ordered / pairs, 1e-12);
	}
	EXPECT_FALSE(auroc(byConfidence({{0.9, true}, {0.1, true}})));
	EXPECT_FALSE(auroc({}));
}

TEST(Statistics, CalibrationErrorIsTheMeanGapOfTheBins)
{
	EXPECT_FALSE(calibrationError({}));
	EXPECT_NEAR(*calibrationError(byConfidence(std::vector<Candidate>(30, {0.75, true}))), 0.25, 1e-12);
	std::vector<Candidate> even(30, {0.5, true});
	for (std::size_t i = 0; i < 15; ++i) even[i].right = false;
	EXPECT_NEAR(*calibrationError(byConfidence(even)), 0.0, 1e-12) << "half of those that say one half are right";
	std::vector<Candidate> perfect;
	for (int i = 0; i < 30; ++i) perfect.push_back({i < 15 ? 0.0 : 1.0, i >= 15});
	EXPECT_NEAR(*calibrationError(byConfidence(perfect)), 0.0, 1e-12);
	std::vector<Candidate> opposite;
	for (int i = 0; i < 30; ++i) opposite.push_back({i < 15 ? 0.0 : 1.0, i < 15});
	// 15 bins of two: the middle one holds a 0 that is right and a 1 that is wrong, and looks calibrated.
	EXPECT_NEAR(*calibrationError(byConfidence(opposite)), 28.0 / 30.0, 1e-12);
}

TEST(Statistics, CurveGoesThroughEveryThreshold)
{
	const std::vector<Candidate> candidates{{0.9, true}, {0.5, false}, {0.9, true}, {0.2, true}};
	const auto curve = precisionRecall(candidates, 5, 100);
	ASSERT_EQ(curve.size(), 3U);
	EXPECT_EQ(curve[0].threshold, 0.9);
	EXPECT_DOUBLE_EQ(curve[0].precision, 1.0);
	EXPECT_DOUBLE_EQ(curve[0].recall, 0.4);
	EXPECT_DOUBLE_EQ(curve[1].precision, 2.0 / 3.0);
	EXPECT_DOUBLE_EQ(curve[1].recall, 0.4);
	EXPECT_DOUBLE_EQ(curve[2].precision, 0.75);
	EXPECT_DOUBLE_EQ(curve[2].recall, 0.6);

	std::vector<Candidate> many;
	for (int i = 0; i < 1000; ++i) many.push_back({i / 1000.0, true});
	const auto thinned = precisionRecall(many, 1000, 101);
	ASSERT_EQ(thinned.size(), 101U);
	EXPECT_EQ(thinned.front().threshold, 0.999);
	EXPECT_EQ(thinned.back().threshold, 0.0);
}
