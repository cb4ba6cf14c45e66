#include <explore/core/geometry.h>
#include <explore/perception/perceive.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "support/analytic_scene.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;
const CPose3D kMount(0.1, 0.0, 0.6, 0, 0, 0);
const test::CameraNoise kKinect{.axial_scale = 1.0, .dropout_share = 0.02};

PerceptionConfig full()
{
	PerceptionConfig config;
	config.method = PerceptionMethod::full;
	return config;
}

Percepts look(const test::Scene& scene, const CPose3D& map_from_robot = {}, const test::CameraNoise& noise = kKinect,
              const RobotConfig& robot = {})
{
	return perceive(test::renderFrame(scene, map_from_robot, kMount, test::xtionIntrinsics(), noise), full(), robot);
}

bool isPositive(const Door& door)
{
	return door.verdict == Verdict::open || door.verdict == Verdict::ajar || door.verdict == Verdict::passage;
}

/** Wall from y = −4 to 4 whose face is at x = 3, 12 cm thick, with a hole of `width_m` × `height_m` around y = 0. */
void thickWall(test::Scene& scene, double width_m, double height_m)
{
	constexpr double kThick_m = 0.12, kHigh_m = 2.5;
	const double piece_m = 4.0 - 0.5 * width_m, x = 3.0 + 0.5 * kThick_m;
	for (const double side : {-1.0, 1.0})
		scene.box({x, side * (4.0 - 0.5 * piece_m), 0.5 * kHigh_m}, {kThick_m, piece_m, kHigh_m});
	if (height_m < kHigh_m) scene.box({x, 0.0, 0.5 * (kHigh_m + height_m)}, {kThick_m, width_m, kHigh_m - height_m});
}

/** A room with such a wall, and a room of 4 m behind. */
test::Scene room(double width_m, double height_m = 2.0)
{
	test::Scene scene;
	scene.floor(-2, -4, 7, 4).wall({7, -4}, {7, 4}, 2.5);
	thickWall(scene, width_m, height_m);
	return scene;
}

std::string described(const Percepts& percepts)
{
	std::ostringstream text;
	for (const Door& door : percepts.doors)
		text << nameOf(door.verdict) << " at " << door.center.transpose() << ", " << door.width_m << " m wide, clear "
		     << door.clear_width_m << '\n';
	return text.str();
}

/** The only door; a failure and an empty one where there is none or more. */
Door onlyDoor(const Percepts& percepts)
{
	EXPECT_EQ(percepts.doors.size(), 1U) << described(percepts);
	return percepts.doors.size() == 1 ? percepts.doors[0] : Door{};
}

TEST(Openings, WidthAndPlaceOfAFrontalDoor)
{
	for (const double width_m : {0.72, 0.8, 0.9, 1.1, 1.3})
	{
		const Door door = onlyDoor(look(room(width_m)));
		EXPECT_EQ(door.verdict, Verdict::open) << width_m;
		EXPECT_NEAR(door.width_m, width_m, 0.02);
		EXPECT_NEAR(door.clear_width_m, width_m, 0.03);
		EXPECT_NEAR(door.center.y(), 0.0, 0.02);
		EXPECT_NEAR(door.center.x(), 3.0, 0.15);
		EXPECT_GT(door.confidence.value_or(0), 0.8);
	}
}

TEST(Openings, SeenAtAnAngle)
{
	for (const double angle_deg : {-60.0, -45.0, 45.0, 60.0})
	{
		const double angle = angle_deg * kDegree_rad;
		const CPose3D map_from_robot(3 - 2.5 * std::cos(angle), -2.5 * std::sin(angle), 0, angle, 0, 0);
		const Percepts percepts = look(room(0.9), map_from_robot);
		const auto open = std::ranges::find_if(percepts.doors, isPositive);
		ASSERT_NE(open, percepts.doors.end()) << angle_deg;
		EXPECT_NEAR(open->width_m, 0.9, 0.03) << angle_deg;
	}
}

TEST(Openings, RolledPitchedAndWithoutAFloorInView)
{
	for (const auto& [pitch_deg, roll_deg] : {std::pair{0.0, 20.0}, {0.0, -30.0}, {-20.0, 0.0}, {15.0, 10.0}})
	{
		const CPose3D mount(0, 0, 1.0, 0, pitch_deg * kDegree_rad, roll_deg * kDegree_rad);
		DepthFrame frame = test::renderFrame(room(1.0), {}, mount, test::xtionIntrinsics(), kKinect);
		const Percepts percepts = perceive(frame, full());
		ASSERT_EQ(std::ranges::count_if(percepts.doors, isPositive), 1) << pitch_deg << ' ' << roll_deg;
		EXPECT_NEAR(percepts.doors[0].width_m, 1.0, 0.03);
	}
}

TEST(Openings, ClosedLeafIsNoWayThrough)
{
	test::Scene scene = room(0.9);
	scene.box({3.12, 0, 1.0}, {0.04, 0.9, 2.0});
	const Percepts percepts = look(scene);
	EXPECT_EQ(std::ranges::count_if(percepts.doors, isPositive), 0);
	ASSERT_EQ(percepts.doors.size(), 1U);
	EXPECT_EQ(percepts.doors[0].verdict, Verdict::closed);
}

TEST(Openings, NicheWindowAndFurnitureAreNotReported)
{
	test::Scene niche = room(0.9);
	niche.box({3.45, 0, 1.0}, {0.1, 1.0, 2.0});
	test::Scene window = room(1.0);
	window.box({3.05, 0, 0.45}, {0.1, 1.0, 0.9});
	test::Scene wardrobes;
	wardrobes.floor(-2, -4, 3, 4)
	    .wall({3, -4}, {3, 4}, 2.5)
	    .box({2.7, -1.0, 1.0}, {0.6, 1.0, 2.0})
	    .box({2.7, 0.9, 1.0}, {0.6, 1.0, 2.0});
	test::Scene cabinet;
	cabinet.floor(-2, -4, 3, 4).wall({3, -4}, {3, 4}, 2.5).box({2.0, 0.0, 0.9}, {0.5, 0.6, 1.8});
	test::Scene table;
	table.floor(-2, -4, 4, 4).wall({4, -4}, {4, 4}, 2.5).box({2.5, 0.0, 0.74}, {0.8, 1.6, 0.04});
	for (const auto& leg : {Eigen::Vector2d(2.15, -0.75), {2.15, 0.75}, {2.85, -0.75}, {2.85, 0.75}})
		table.box({leg.x(), leg.y(), 0.36}, {0.06, 0.06, 0.72});
	for (const test::Scene& scene : {niche, window, wardrobes, cabinet, table}) EXPECT_EQ(described(look(scene)), "");
}

TEST(Openings, PillarsBeforeAWallAreNothing)
{
	test::Scene scene;
	scene.floor(-2, -4, 5, 4).wall({5, -4}, {5, 4}, 3.0);
	for (const double y : {-2.0, -0.7, 0.6, 1.9}) scene.box({3.1, y, 1.5}, {0.3, 0.3, 3.0});
	const Percepts percepts = look(scene);
	EXPECT_EQ(std::ranges::count_if(percepts.doors, isPositive), 0);
}

TEST(Openings, CounterAndStepAcrossBlock)
{
	test::Scene counter = room(1.0);
	counter.box({3.1, 0, 0.5}, {0.3, 1.0, 1.0});
	test::Scene step = room(1.0);
	step.box({3.05, 0, 0.1}, {0.2, 1.0, 0.2});
	test::Scene threshold = room(1.0);
	threshold.box({3.05, 0, 0.015}, {0.1, 1.0, 0.03});
	EXPECT_EQ(std::ranges::count_if(look(counter).doors, isPositive), 0);
	EXPECT_EQ(onlyDoor(look(step)).verdict, Verdict::blocked);
	EXPECT_EQ(onlyDoor(look(threshold)).verdict, Verdict::open);
}

TEST(Openings, SomebodyInTheDoorwayBlocksIt)
{
	test::Scene scene = room(1.0);
	scene.box({3.3, 0.02, 0.85}, {0.3, 0.45, 1.7});
	EXPECT_EQ(onlyDoor(look(scene)).verdict, Verdict::blocked);
}

TEST(Openings, NoFloorBehindIsADrop)
{
	test::Scene scene;
	scene.floor(-2, -4, 3, 4).floor(3, -4, 8, 4, -0.6).wall({7, -4}, {7, 4}, 2.5);
	thickWall(scene, 1.0, 2.0);
	const CPose3D map_from_robot(0.8, 0, 0, 0, 0, 0);
	EXPECT_EQ(onlyDoor(look(scene, map_from_robot)).verdict, Verdict::drop);
}

TEST(Openings, NothingComesBackIsUnknown)
{
	test::CameraNoise short_sighted = kKinect;
	short_sighted.max_depth_m = 3.4;
	const Percepts percepts = look(room(0.9), {}, short_sighted);
	EXPECT_EQ(std::ranges::count_if(percepts.doors, isPositive), 0);
	EXPECT_EQ(onlyDoor(percepts).verdict, Verdict::unknown);
}

TEST(Openings, LeafLeavesItsClearWidth)
{
	test::Scene scene = room(0.9);
	const double angle = 60 * kDegree_rad;
	const Eigen::Vector3d hinge(3.0, 0.45, 0.0);
	scene.patch({hinge, 0.9 * Eigen::Vector3d(std::sin(angle), -std::cos(angle), 0), Eigen::Vector3d(0, 0, 2.0)});
	const Percepts percepts = look(scene);
	const auto ajar = std::ranges::find(percepts.doors, Verdict::ajar, &Door::verdict);
	ASSERT_NE(ajar, percepts.doors.end()) << described(percepts);
	const Door door = *ajar;
	EXPECT_NEAR(door.width_m, 0.9, 0.05);
	EXPECT_NEAR(door.clear_width_m, 0.9 * std::sin(angle), 0.06);
}

TEST(Openings, LeafThatStandsTowardTheRobotLeavesTheWholeWidth)
{
	test::Scene scene = room(0.9);
	scene.patch({{3.0, 0.45, 0.0}, {-0.9, 0.0, 0.0}, {0, 0, 2.0}});
	const Percepts percepts = look(scene);
	const auto open = std::ranges::find_if(percepts.doors, isPositive);
	ASSERT_NE(open, percepts.doors.end());
	EXPECT_NEAR(open->clear_width_m, 0.9, 0.08);
}

TEST(Openings, DoorInTheCornerOfARoom)
{
	test::Scene scene;
	scene.floor(-2, -4, 7, 1)
	    .wall({3, -4}, {3, 0.5}, 2.5, {{3.6, 0.9, 2.0}})
	    .wall({-2, 0.5}, {3, 0.5}, 2.5)
	    .wall({7, -4}, {7, 4}, 2.5);
	const Percepts percepts = look(scene);
	const auto open = std::ranges::find_if(percepts.doors, isPositive);
	ASSERT_NE(open, percepts.doors.end());
	EXPECT_NEAR(open->width_m, 0.9, 0.03);
	EXPECT_NEAR(open->center.y(), 0.05, 0.03);
}

TEST(Openings, OpeningsWithoutLintelOrTooWideArePassages)
{
	EXPECT_EQ(onlyDoor(look(room(1.4, 2.5), CPose3D(-1.5, 0, 0, 0, 0, 0))).verdict, Verdict::passage);
	const Door wide = onlyDoor(look(room(2.4), CPose3D(-1.0, 0, 0, 0, 0, 0)));
	EXPECT_EQ(wide.verdict, Verdict::passage);
	EXPECT_NEAR(wide.width_m, 2.4, 0.03);
}

TEST(Openings, JambOutOfViewIsPartial)
{
	const Percepts percepts = look(room(1.0), CPose3D(1.8, 0.9, 0, 0, 0, 0));
	EXPECT_EQ(std::ranges::count_if(percepts.doors, isPositive), 0);
}

TEST(Openings, WhatFitsDependsOnTheRobot)
{
	const test::Scene narrow = room(0.62);
	EXPECT_TRUE(isPositive(onlyDoor(look(narrow))));
	RobotConfig wide_robot;
	wide_robot.radius_m = 0.4;
	const Door door = onlyDoor(look(narrow, {}, kKinect, wide_robot));
	EXPECT_LT(door.confidence.value_or(1.0), 0.5);
	EXPECT_NEAR(door.clear_width_m, 0.62, 0.03);
}

TEST(Openings, EmptyAndTinyImages)
{
	DepthFrame frame = test::renderFrame(room(0.9), {}, kMount, test::xtionIntrinsics(64, 48), {});
	EXPECT_NO_THROW((void)perceive(frame, full()));
	std::ranges::fill(frame.image.depth_m, 0.0F);
	EXPECT_TRUE(perceive(frame, full()).doors.empty());
}
}  // namespace
}  // namespace explore
