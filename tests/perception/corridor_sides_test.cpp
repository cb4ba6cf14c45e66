#include <explore/perception/corridor_sides.h>
#include <gtest/gtest.h>

#include <random>

namespace explore
{
namespace
{
/** Walls of random stretches; never open on both sides, which is a question of its own. */
SideProfiles randomSides(std::mt19937& random)
{
	SideProfiles sides;
	for (SideProfile* side : {&sides.left, &sides.right})
	{
		bool wall = random() % 2 == 0;
		for (std::size_t strip = 20; strip < 120; ++strip)
		{
			if (random() % 8 == 0) wall = !wall;
			side->on[strip] = wall ? 10 : 0;
			side->behind[strip] = !wall && side == &sides.left ? 10 : 0;
		}
	}
	return sides;
}

/** By trying each end: the definition, word by word. */
std::optional<Overlap> overlapByTrying(const SideProfiles& sides, double share)
{
	std::optional<Overlap> longest;
	std::size_t first = 0;
	for (bool left = false, right = false; first < SideProfile::kStrips; ++first)
	{
		left = left || sides.left.isWall(first);
		right = right || sides.right.isWall(first);
		if (left && right) break;
	}
	for (std::size_t last = first; last < SideProfile::kStrips; ++last)
	{
		int left = 0, right = 0, left_after = 0, right_after = 0;
		for (std::size_t strip = first; strip < SideProfile::kStrips; ++strip)
		{
			(strip <= last ? left : left_after) += sides.left.isWall(strip) ? 1 : 0;
			(strip <= last ? right : right_after) += sides.right.isWall(strip) ? 1 : 0;
		}
		const bool beyond_one =
		    (left_after == 0 && !sides.left.isWall(last)) || (right_after == 0 && !sides.right.isWall(last));
		const double fewest = share * static_cast<double>(last + 1 - first);
		if (!beyond_one && left >= fewest && right >= fewest)
			longest = Overlap{SideProfile::along_m(first) - 0.05, SideProfile::along_m(last) + 0.05};
	}
	return longest;
}

TEST(CorridorSides, OverlapIsTheLongestThatBothWallsFill)
{
	std::mt19937 random(11);
	int with = 0;
	for (int run = 0; run < 300; ++run)
	{
		const SideProfiles sides = randomSides(random);
		const auto fast = overlapOf(sides, 0.4), slow = overlapByTrying(sides, 0.4);
		ASSERT_EQ(fast.has_value(), slow.has_value()) << run;
		if (!fast) continue;
		++with;
		EXPECT_NEAR(fast->from_m, slow->from_m, 1e-9) << run;
		EXPECT_NEAR(fast->to_m, slow->to_m, 1e-9) << run;
	}
	EXPECT_GT(with, 100);
}

TEST(CorridorSides, OverlapEndsWhereBothOpenAndNoWallFollows)
{
	SideProfiles sides;
	for (SideProfile* side : {&sides.left, &sides.right})
	{
		for (std::size_t strip = 30; strip < 60; ++strip) side->on[strip] = side->points[strip] = 10;
		for (std::size_t strip = 60; strip < 72; ++strip) side->behind[strip] = 10;
		for (std::size_t strip = 72; strip < 80; ++strip) side->on[strip] = 10;  // a wall across, seen in one place
		side->points[76] = 80;
	}
	EXPECT_NEAR(overlapOf(sides, 0.33)->to_m, SideProfile::along_m(59) + 0.05, 1e-9);
	for (SideProfile* side : {&sides.left, &sides.right})
		for (std::size_t strip = 72; strip < 80; ++strip) side->points[strip] = 10;  // walls that go on
	EXPECT_NEAR(overlapOf(sides, 0.33)->to_m, SideProfile::along_m(79) + 0.05, 1e-9);
}

TEST(CorridorSides, RaysAreCountedWhereTheyCrossThePlane)
{
	// One point on the left wall 3 m ahead, one 2 m behind that wall's plane, one in front of it.
	FacingWalls pair;
	pair.left_m = pair.right_m = 1.0;
	PlanPoints points;
	points.x = {3, 6, 2};
	points.y = {1, 3, 0.5F};
	points.sigma_per_m = {0, 0, 0};
	points.sample = {0, 1, 2};
	points.row = {0, 1, 2};
	const SideProfiles sides = sideProfiles(pair, points, turnedTo(pair.direction, points), 0.001, {});
	const auto strip = [](double along_m)
	{ return static_cast<std::size_t>((along_m - SideProfile::kFirst_m) / 0.1 + 1e-6); };
	EXPECT_EQ(sides.left.on[strip(3.0)] + sides.left.on[strip(2.95)], 2) << "on the border of two strips";
	EXPECT_GE(sides.left.behind[strip(2.0)], 1) << "(6, 3) is seen through y = 1 at x = 2";
	int all = 0;
	for (const SideProfile* side : {&sides.left, &sides.right})
		for (std::size_t i = 0; i < SideProfile::kStrips; ++i) all += side->on[i] + side->behind[i];
	EXPECT_LE(all, 4) << "what is before the plane says nothing";
}
}  // namespace
}  // namespace explore
