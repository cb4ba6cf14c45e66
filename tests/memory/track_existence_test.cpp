#include <explore/core/geometry.h>
#include <explore/memory/track_existence.h>
#include <gtest/gtest.h>

#include "door_looks.h"

namespace explore::test
{
namespace
{
Viewpoint viewAt(double x_m, double yaw_rad, double t_s)
{
	return {robotAt(x_m, 0, yaw_rad), t_s};
}

TEST(TrackExistence, ALookIsAStepATurnOrAMomentLater)
{
	const Viewpoint last = viewAt(1.0, 0.2, 100.0);
	EXPECT_FALSE(isNewLook(last, viewAt(1.04, 0.2 + 2.5 * kDegree_rad, 100.1)));
	EXPECT_TRUE(isNewLook(last, viewAt(1.05, 0.2, 100.1)));
	EXPECT_TRUE(isNewLook(last, viewAt(1.0, 0.2 - 3 * kDegree_rad, 100.1)));
	EXPECT_TRUE(isNewLook(last, viewAt(1.0, 0.2, 100.2)));
}

/** Looks from a new place each, '+' a hit. */
Existence after(const std::string& looks, double hit_probability = 0.9, double miss_probability = 0.3)
{
	Existence existence;
	double x_m = 0;
	for (const char look : looks)
	{
		const bool hit = look == '+';
		addLook(existence, {viewAt(x_m, 0, x_m), hit, logOdds(hit ? hit_probability : miss_probability)}, {});
		x_m += 0.5;
	}
	return existence;
}

TEST(TrackExistence, ThreeOfFiveLooksConfirm)
{
	EXPECT_FALSE(after("++").confirmed);
	EXPECT_TRUE(after("+++").confirmed);
	EXPECT_TRUE(after("+-+-+").confirmed);
	EXPECT_TRUE(after("++--+").confirmed);
	EXPECT_FALSE(after("+--+-").confirmed);
	EXPECT_FALSE(after("++----+").confirmed) << "two of them are too long ago";
}

TEST(TrackExistence, HitsThatSayLittleDoNotConfirm)
{
	EXPECT_FALSE(after("+++", 0.55).confirmed);
	EXPECT_TRUE(after("++++++++", 0.6).confirmed);
}

TEST(TrackExistence, WhatVanishedIsUnconfirmedAndThenDies)
{
	Existence existence = after("++++++++++++++++++++++++");
	int looks = 0;
	for (; existence.confirmed && looks < 100; ++looks)
		addLook(existence, {viewAt(100.0 + looks, 0, 100.0 + looks), false, logOdds(0.3)}, {});
	EXPECT_GE(looks, 4) << "one wrong look is nothing";
	EXPECT_LE(looks, 9);
	for (; !isDead(existence, {}) && looks < 100; ++looks)
		addLook(existence, {viewAt(100.0 + looks, 0, 100.0 + looks), false, logOdds(0.3)}, {});
	EXPECT_LE(looks, 12);
}

TEST(TrackExistence, LooksFromOnePlaceTellLess)
{
	Existence moving, standing;
	for (int i = 0; i < 4; ++i)
	{
		addLook(moving, {viewAt(0.5 * i, 0, i), true, logOdds(0.7)}, {});
		addLook(standing, {viewAt(0, 0, i), true, logOdds(0.7)}, {});
	}
	EXPECT_NEAR(moving.log_odds, 4 * logOdds(0.7), 1e-12);
	EXPECT_LT(standing.log_odds, 0.6 * moving.log_odds);
	EXPECT_NEAR(novelty(viewAt(0, 0, 0), viewAt(0, 10 * kDegree_rad, 0), 0.4), 1.0, 1e-9);
}

TEST(TrackExistence, ProbabilityAndLogOddsAreEachOthersInverse)
{
	for (const double probability : {0.01, 0.2, 0.5, 0.93, 0.999})
		EXPECT_NEAR(probabilityOf(logOdds(probability)), probability, 1e-12);
}
}  // namespace
}  // namespace explore::test
