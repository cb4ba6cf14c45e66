#include <explore/perception/pass_probability.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "support/fit_trees.h"

namespace explore
{
namespace
{
/** "Is feature 0 > 0.5?" no: −1; yes: "is feature 1 > 2?" no: 0.2, yes: 1.5. */
PassTree smallTree()
{
	PassTree tree{};
	tree.at(0) = {0, 0.5F, 1};
	tree.at(1) = {-1, 0.0F, -1000};
	tree.at(2) = {1, 2.0F, 3};
	tree.at(3) = {-1, 0.0F, 200};
	tree.at(4) = {-1, 0.0F, 1500};
	return tree;
}

TEST(PassProbability, IsTheLogisticFunctionOfTheSumOfAllVotes)
{
	const std::vector<PassTree> trees{smallTree(), smallTree()};
	OpeningFeatures features{};
	EXPECT_NEAR(passProbability(features, trees), 1.0 / (1.0 + std::exp(2.0)), 1e-12);
	features[0] = 1.0F;
	EXPECT_NEAR(passProbability(features, trees), 1.0 / (1.0 + std::exp(-0.4)), 1e-12);
	features[1] = 2.5F;
	EXPECT_NEAR(passProbability(features, trees), 1.0 / (1.0 + std::exp(-3.0)), 1e-12);
	EXPECT_EQ(passProbability(features, {}), 0.5);
}

TEST(PassProbability, ShippedTreesAskAboutWhatThereIsAndEndInVotes)
{
	ASSERT_GE(passTrees().size(), 50U);
	std::set<int> asked;
	for (const PassTree& tree : passTrees())
		for (std::size_t n = 0; n < tree.size(); ++n)
		{
			const PassNode& node = tree.at(n);
			if (node.feature < 0) continue;
			ASSERT_LT(static_cast<std::size_t>(node.feature), kOpeningFeatures);
			// Always further down: no walk goes on for ever.
			ASSERT_GT(node.next, static_cast<int>(n));
			ASSERT_LT(static_cast<std::size_t>(node.next) + 1, tree.size());
			asked.insert(node.feature);
		}
	EXPECT_GE(asked.size(), kOpeningFeatures / 2);
}

TEST(OpeningFeatures, AMirroredOpeningIsTheSame)
{
	std::mt19937 random(4);
	const auto draw = [&] { return static_cast<double>(random() % 1000) / 500.0; };
	for (int round = 0; round < 50; ++round)
	{
		OpeningFrame frame{{-draw(), static_cast<JambKind>(random() % 4), draw(), 40},
		                   {draw(), static_cast<JambKind>(random() % 4), draw(), 40}};
		OpeningMeasure measure;
		measure.evidence.left_wall = draw();
		measure.evidence.right_wall = draw();
		measure.across_left = draw();
		measure.across_right = draw();
		measure.evidence.range_m = 2.0 + draw();
		OpeningContext context{
		    0.54, {draw(), random() % 2 == 0, random() % 2 == 0}, {draw(), random() % 2 == 0, random() % 2 == 0}, 3, 2,
		    2};
		const OpeningFeatures one = openingFeatures(frame, measure, context);
		std::swap(frame.left, frame.right);
		std::swap(frame.left.along_m, frame.right.along_m);
		std::swap(measure.evidence.left_wall, measure.evidence.right_wall);
		std::swap(measure.across_left, measure.across_right);
		std::swap(context.left, context.right);
		EXPECT_EQ(openingFeatures(frame, measure, context), one);
	}
}

TEST(OpeningFeatures, HaveNamesThatDiffer)
{
	const auto& names = openingFeatureNames();
	EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), kOpeningFeatures);
}

/** Passable where exactly one of two features is large: no single question tells. One in twenty is labelled wrongly. */
std::vector<test::KnownOpening> eitherOr(std::size_t count, unsigned seed, bool noisy)
{
	std::mt19937 random(seed);
	std::vector<test::KnownOpening> openings(count);
	for (test::KnownOpening& opening : openings)
	{
		for (float& value : opening.features) value = static_cast<float>(random() % 10000) / 10000.0F;
		const bool truth = (opening.features[3] > 0.4F) != (opening.features[7] > 0.6F);
		opening.passable = truth != (noisy && random() % 20 == 0);
	}
	return openings;
}

TEST(FitTrees, FindsWhatNoSingleQuestionTells)
{
	test::TreeFitConfig config;
	config.trees = 40;
	const auto trees = test::fitTrees(eitherOr(4000, 1, true), config);
	int right = 0;
	double brier = 0;
	const auto fresh = eitherOr(2000, 2, false);
	for (const test::KnownOpening& opening : fresh)
	{
		const double p = passProbability(opening.features, trees);
		right += static_cast<int>((p > 0.5) == opening.passable);
		brier += std::pow(p - (opening.passable ? 1.0 : 0.0), 2) / static_cast<double>(fresh.size());
	}
	EXPECT_GE(right, 1940);
	EXPECT_LT(brier, 0.03);
}

TEST(FitTrees, IsDeterministicAndTellsTheRateWhereNothingElseIsKnown)
{
	auto openings = eitherOr(2000, 3, false);
	std::mt19937 random(5);
	for (test::KnownOpening& opening : openings)
	{
		opening.features.fill(1.0F);
		opening.passable = random() % 10 < 3;
	}
	const auto rate = std::ranges::count_if(openings, &test::KnownOpening::passable);
	const auto trees = test::fitTrees(openings, {});
	EXPECT_NEAR(passProbability(openings[0].features, trees), static_cast<double>(rate) / 2000.0, 0.01);

	test::TreeFitConfig config;
	config.trees = 3;
	const auto known = eitherOr(500, 6, true);
	const auto one = test::fitTrees(known, config), two = test::fitTrees(known, config);
	for (std::size_t i = 0; i < one.size(); ++i)
		EXPECT_EQ(passProbability(known[i].features, one), passProbability(known[i].features, two));
}
}  // namespace
}  // namespace explore
