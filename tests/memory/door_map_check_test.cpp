#include <explore/memory/door_map_check.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "door_looks.h"

namespace explore::test
{
namespace
{
/** Walls and furniture as boxes on the plan, up to 2 m high. */
struct Box
{
	double x_min, x_max, y_min, y_max;

	[[nodiscard]] bool holds(double x_m, double y_m) const
	{
		return x_m >= x_min && x_m <= x_max && y_m >= y_min && y_m <= y_max;
	}
};

/** Known within `seen`, occupied in the boxes. */
OccupancyQuery mapOf(const std::vector<Box>& boxes, const Box& seen)
{
	return [boxes, seen](const Eigen::Vector3d& point)
	{
		if (!seen.holds(point.x(), point.y()) || point.z() > 2.0) return VoxelState::unknown;
		for (const Box& box : boxes)
			if (box.holds(point.x(), point.y())) return VoxelState::occupied;
		return VoxelState::free;
	};
}

// The robot looks along +x at a wall at x = 0 with an opening of 1 m, its middle at y = 0.
const DoorPlace kPlace{.center_in_map = {0, 0}, .normal_rad = std::numbers::pi, .width_m = 1.0};
const Box kSeen{-6, 6, -4, 4};
const Box kLeftWall{-0.06, 0.06, 0.5, 4}, kRightWall{-0.06, 0.06, -4, -0.5};

std::optional<Verdict> objection(const std::vector<Box>& boxes, const Box& seen = kSeen)
{
	return objectionTo(kPlace, 0.95, mapOf(boxes, seen), {}, {});
}

RobotConfig mav()
{
	RobotConfig robot;
	robot.kind = RobotKind::mav;
	robot.radius_m = 0.30;
	robot.height_m = 0.25;
	return robot;
}

/** Occupied between these heights, all over. */
OccupancyQuery slab(double from_m, double to_m)
{
	return [=](const Eigen::Vector3d& point)
	{ return point.z() >= from_m && point.z() <= to_m ? VoxelState::occupied : VoxelState::free; };
}

TEST(DoorMapCheck, AnOpenDoorwayIsNoReasonToObject)
{
	EXPECT_FALSE(objection({kLeftWall, kRightWall}));
	EXPECT_NEAR(mappedClearWidth(kPlace, mapOf({kLeftWall, kRightWall}, kSeen), {}, {}), 1.0, 1e-9);
}

TEST(DoorMapCheck, WhatWasNeverSeenIsNoReasonEither)
{
	EXPECT_FALSE(objectionTo(kPlace, 0.95, mapOf({}, {9, 9, 9, 9}), {}, {}));
}

TEST(DoorMapCheck, TheBackOfAWallSeenFromElsewhereBlocksIt)
{
	EXPECT_EQ(objection({kLeftWall, kRightWall, {0.1, 0.2, -4, 4}}), Verdict::blocked);
}

TEST(DoorMapCheck, AHighThresholdStopsARobotOnTheGroundOnly)
{
	EXPECT_EQ(objectionTo(kPlace, 0.95, slab(0, 0.2), {}, {}), Verdict::blocked);
	EXPECT_FALSE(objectionTo(kPlace, 0.95, slab(0, 0.05), {}, {}));
	EXPECT_FALSE(objectionTo(kPlace, 0.95, slab(0, 0.2), mav(), {}));
}

TEST(DoorMapCheck, WhatLeavesRoomEnoughDoesNot)
{
	const Box leaf{0.0, 0.25, 0.3, 0.5};
	EXPECT_FALSE(objection({kLeftWall, kRightWall, leaf}));
	EXPECT_NEAR(mappedClearWidth(kPlace, mapOf({leaf}, kSeen), {}, {}), 0.8, 0.051);
	const Box post{0.0, 0.25, -0.1, 0.1};
	EXPECT_EQ(objection({kLeftWall, kRightWall, post}), Verdict::blocked) << "0.4 m on either side";
}

TEST(DoorMapCheck, StrayVoxelsDoNotBlockItButAThinPostDoes)
{
	// Pixels on the edge of a jamb: a voxel here and there, slantwise through the opening.
	const OccupancyQuery stray = [](const Eigen::Vector3d& point)
	{
		const bool on_line = std::abs(point.x() - 0.5 * point.y()) < 0.03;
		return on_line && std::abs(point.z() - 0.4) < 0.03 ? VoxelState::occupied : VoxelState::free;
	};
	EXPECT_FALSE(objectionTo(kPlace, 0.95, stray, {}, {}));
	EXPECT_EQ(objection({kLeftWall, kRightWall, {0.0, 0.05, -0.03, 0.03}}), Verdict::blocked);
}

TEST(DoorMapCheck, WhatIsHigherThanTheRobotIsNotInItsWay)
{
	const auto high = [](const Eigen::Vector3d& point)
	{ return point.z() > 0.7 ? VoxelState::occupied : VoxelState::free; };
	EXPECT_NEAR(mappedClearWidth(kPlace, high, {}, {}), 1.0, 1e-9);
	RobotConfig tall;
	tall.height_m = 1.2;
	EXPECT_EQ(mappedClearWidth(kPlace, high, tall, {}), 0.0);
}

TEST(DoorMapCheck, ARobotThatFliesFindsTheAltitudeAtWhichItFits)
{
	EXPECT_NEAR(mappedClearWidth(kPlace, slab(0, 1.0), mav(), {}), 1.0, 1e-9) << "over a counter";
	EXPECT_NEAR(mappedClearWidth(kPlace, slab(1.0, 3.0), mav(), {}), 1.0, 1e-9) << "under a shutter";
	EXPECT_EQ(mappedClearWidth(kPlace, slab(0.5, 3.0), mav(), {}), 0.0) << "too low for its flight band";
	EXPECT_EQ(mappedClearWidth(kPlace, slab(0, 1.85), mav(), {}), 0.0) << "0.15 m under a lintel that was not seen";
	EXPECT_EQ(mappedClearWidth(kPlace, slab(0, 1.0), {}, {}), 0.0) << "a counter stops a robot on the ground";
	DoorPlace low = kPlace;
	low.height_m = 0.55;
	EXPECT_EQ(mappedClearWidth(low, slab(8, 9), mav(), {}), 0.0) << "a hatch in which it has no room";
	low.height_m = 0.9;
	EXPECT_NEAR(mappedClearWidth(low, slab(8, 9), mav(), {}), 1.0, 1e-9);
}

TEST(DoorMapCheck, WhatARobotThatFliesMeetsAtEveryAltitudeBlocksIt)
{
	const OccupancyQuery person = [](const Eigen::Vector3d& point)
	{ return std::abs(point.y()) < 0.25 && point.z() < 1.9 ? VoxelState::occupied : VoxelState::free; };
	EXPECT_NEAR(mappedClearWidth(kPlace, person, mav(), {}), 0.25, 0.051);
	EXPECT_EQ(objectionTo(kPlace, 0.95, person, mav(), {}), Verdict::blocked);
}

/** A room in front with a cupboard, a table and its walls. */
const std::vector<Box> kRoom{{-3.1, -2.9, -2.5, 2.5}, {-2.2, -1.8, 0.6, 1.4}, {-1.6, -1.2, -1.4, -0.7}};

std::vector<Box> withImage(std::vector<Box> boxes, double shift_m = 0)
{
	const std::size_t count = boxes.size();
	for (std::size_t i = 0; i < count; ++i)
		boxes.push_back({-boxes[i].x_max + shift_m, -boxes[i].x_min + shift_m, boxes[i].y_min, boxes[i].y_max});
	boxes.push_back(kLeftWall);
	boxes.push_back(kRightWall);
	return boxes;
}

TEST(DoorMapCheck, AMirrorImageOfTheRoomIsNoDoor)
{
	EXPECT_EQ(objection(withImage(kRoom)), Verdict::unknown);
}

TEST(DoorMapCheck, AnotherRoomIsNoMirrorImage)
{
	std::vector<Box> boxes = kRoom;
	boxes.insert(boxes.end(), {kLeftWall, kRightWall, {2.2, 2.4, -2.5, 2.5}, {0.8, 1.4, -1.4, -0.9}});
	EXPECT_FALSE(objection(boxes));
	EXPECT_FALSE(objection(withImage(kRoom, 0.4))) << "an image that is not where a mirror's would be";
}

TEST(DoorMapCheck, ACorridorThatGoesOnIsNoMirrorImage)
{
	const Box left{-5, 5, 0.85, 1.15}, right{-5, 5, -1.15, -0.85};
	EXPECT_FALSE(objection({kLeftWall, kRightWall, left, right}));
	const MirrorImage image = mirrorImageOf(kPlace, mapOf({kLeftWall, kRightWall, left, right}, kSeen), {});
	EXPECT_GT(image.share, 0.95) << "although its walls are each other's images";
	EXPECT_LT(image.contrast, 0.1);
}
}  // namespace
}  // namespace explore::test
