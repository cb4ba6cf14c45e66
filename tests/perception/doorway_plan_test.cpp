#include <explore/perception/doorway_plan.h>
#include <gtest/gtest.h>

#include <cmath>

namespace explore
{
namespace
{
constexpr double kFront_m = 0.9, kBehind_m = 0.74, kRays_per_m2 = 20000.0;

/** Rays that all go `per_m` sideways for each metre behind the wall, between the jambs. */
void look(DoorwayPlan& plan, double width_m, float per_m)
{
	constexpr float kDepth_m = 0.74F;
	for (double along_m = 0.005; along_m < width_m; along_m += 0.01)
		plan.addSight(static_cast<float>(along_m), static_cast<float>(along_m) + per_m * kDepth_m, kDepth_m);
}

void stand(DoorwayPlan& plan, float along_m, float behind_m)
{
	for (int i = 0; i < 200; ++i) plan.add(along_m, behind_m, 0.01F * static_cast<float>(i));
}

TEST(DoorwayPlan, WhereRaysPassedIsALane)
{
	DoorwayPlan plan(0.9, kFront_m, kBehind_m, kRays_per_m2);
	EXPECT_EQ(plan.seenLane_m(), 0.0);
	look(plan, 0.9, 0.0F);
	EXPECT_NEAR(plan.seenLane_m(), 0.9, 0.05);
	EXPECT_TRUE(plan.obstacles().empty());
	EXPECT_EQ(plan.top_m(), 0.0);
}

TEST(DoorwayPlan, WhatStandsThereNarrowsTheLane)
{
	DoorwayPlan plan(1.0, kFront_m, kBehind_m, kRays_per_m2);
	look(plan, 1.0, 0.0F);
	stand(plan, 0.33F, 0.2F);
	EXPECT_NEAR(plan.seenLane_m(), 0.65, 0.06);
	ASSERT_EQ(plan.obstacles().size(), 1U);
	EXPECT_NEAR((plan.obstacles()[0] - Eigen::Vector2d(0.33, 0.2)).norm(), 0.0, 0.01);
	EXPECT_NEAR(plan.top_m(), 1.99, 1e-5);
}

TEST(DoorwayPlan, SeenFromTheSideTheLaneGoesThereAndIsNarrower)
{
	for (const float per_m : {-1.0F, 1.0F})
	{
		DoorwayPlan plan(1.0, kFront_m, kBehind_m, kRays_per_m2);
		look(plan, 1.0, per_m);
		// 45°: no wider than the opening seen along the lane; half of its cells have not been seen at all.
		EXPECT_NEAR(plan.seenLane_m(), 1.0 / std::sqrt(2.0), 0.08) << per_m;
	}
}

TEST(DoorwayPlan, AFewStrayReturnsAreNoObstacle)
{
	DoorwayPlan plan(0.9, kFront_m, kBehind_m, kRays_per_m2);
	look(plan, 0.9, 0.0F);
	for (int i = 0; i < 3; ++i) plan.add(0.45F, 0.3F, 1.0F);
	EXPECT_TRUE(plan.obstacles().empty());
	EXPECT_NEAR(plan.seenLane_m(), 0.9, 0.05);
}
}  // namespace
}  // namespace explore
