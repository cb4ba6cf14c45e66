#include <explore/perception/door_gaps.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/random_points.h"

namespace explore
{
namespace
{
const Plane kFloor{Eigen::Vector3d::UnitZ(), 0.0};

/** A hole in the wall: along the wall from..to, between the two heights. */
struct Hole
{
	double from_m, to_m, bottom_m, top_m;
};

/** A 5 m × 2.4 m wall through (3, 0) turned by `yaw`, points every 2 cm, with holes. */
WallPatch wallWith(const std::vector<Hole>& holes, double yaw_rad = 0.0)
{
	const Eigen::AngleAxisd turn(yaw_rad, Eigen::Vector3d::UnitZ());
	const Eigen::Vector3d along = turn * Eigen::Vector3d::UnitY();
	const Eigen::Vector3d centre(3, 0, 0);
	WallPatch patch;
	patch.wall.plane = planeThrough(centre, turn * Eigen::Vector3d(-1, 0, 0));
	for (int i = 0; i <= 250; ++i)
		for (int j = 0; j <= 120; ++j)
		{
			const double s = -2.5 + 0.02 * i, z = 0.02 * j;
			bool in_hole = false;
			for (const Hole& hole : holes)
				in_hole |= s > hole.from_m && s < hole.to_m && z > hole.bottom_m && z < hole.top_m;
			if (!in_hole)
				patch.inliers_in_robot.push_back((centre + s * along + z * Eigen::Vector3d::UnitZ()).cast<float>());
		}
	patch.wall.inliers = patch.inliers_in_robot.size();
	return patch;
}

TEST(DoorGaps, DoorAtAnyWallAngle)
{
	for (int angle_deg = -75; angle_deg <= 75; angle_deg += 15)
	{
		const double yaw = angle_deg * std::numbers::pi / 180;
		const auto doors = findDoors(wallWith({{0.4, 1.3, -0.1, 2.0}}, yaw), kFloor, {});
		ASSERT_EQ(doors.size(), 1U) << angle_deg << " deg";
		const Eigen::Vector3d expected =
		    Eigen::Vector3d(3, 0, 1.0) +
		    0.85 * (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d::UnitY());
		EXPECT_LT((doors[0].center - expected).norm(), 0.05) << angle_deg << " deg";
		EXPECT_NEAR(doors[0].width_m, 0.9, 0.045);
		EXPECT_EQ(doors[0].verdict, Verdict::open);
		EXPECT_FALSE(doors[0].confidence);
		EXPECT_FALSE(doors[0].height_m);
	}
}

TEST(DoorGaps, WidthDecides)
{
	for (const double width_m : {0.5, 0.7, 0.74, 0.84, 1.0, 1.2, 1.5, 1.54, 1.64, 2.0})
	{
		const auto doors = findDoors(wallWith({{-0.5 * width_m, 0.5 * width_m, -0.1, 2.0}}), kFloor, {});
		EXPECT_EQ(doors.size(), width_m >= 0.8 && width_m <= 1.6 ? 1U : 0U) << width_m << " m";
	}
}

TEST(DoorGaps, BothHeightsMustShowTheGap)
{
	EXPECT_TRUE(findDoors(wallWith({{-0.5, 0.5, 1.0, 2.0}}), kFloor, {}).empty()) << "window with a sill at 1 m";
	EXPECT_TRUE(findDoors(wallWith({{-0.5, 0.5, -0.1, 1.0}}), kFloor, {}).empty()) << "space under a counter";
	const WallPatch shifted = wallWith({{-0.5, 0.5, -0.1, 1.0}, {-0.2, 0.8, 0.98, 2.0}});
	EXPECT_EQ(scanGaps(shifted, kFloor, 0.8, {}).size(), 1U);
	EXPECT_EQ(scanGaps(shifted, kFloor, 1.2, {}).size(), 1U);
	EXPECT_TRUE(findDoors(shifted, kFloor, {}).empty()) << "gaps 0.3 m apart do not agree";
}

TEST(DoorGaps, TwoDoorsInOneWall)
{
	const auto doors = findDoors(wallWith({{-1.8, -0.9, -0.1, 2.0}, {0.6, 1.6, -0.1, 2.1}}), kFloor, {});
	ASSERT_EQ(doors.size(), 2U);
	EXPECT_NEAR(std::abs(doors[0].center.y() - doors[1].center.y()), 2.45, 0.05);
}

TEST(DoorGaps, HeightIsMeasuredFromTheGroundNotTheSensor)
{
	const Plane ground_below{Eigen::Vector3d::UnitZ(), 0.6};  // the floor lies 0.6 m below the frame's origin
	WallPatch wall = wallWith({{-0.5, 0.5, -0.1, 2.0}});
	for (float& z : wall.inliers_in_robot.z) z -= 0.6F;
	const auto doors = findDoors(wall, ground_below, {});
	ASSERT_EQ(doors.size(), 1U);
	EXPECT_NEAR(doors[0].center.z(), 1.0 - 0.6, 0.05);
}

/** The gaps of a band by comparing every point with every other: a gap is a pair with nothing between. */
std::size_t slowGapCount(const std::vector<double>& along, double min_m, double max_m)
{
	std::size_t count = 0;
	for (const double a : along)
		for (const double b : along)
		{
			bool empty_between = b > a;
			for (const double c : along) empty_between &= !(c > a && c < b);
			if (empty_between && b - a >= min_m && b - a <= max_m) ++count;
		}
	return count;
}

TEST(DoorGaps, ScanEqualsAllPairsOnRandomBands)
{
	std::mt19937 random(31);
	for (int run = 0; run < 200; ++run)
	{
		WallPatch wall;
		wall.wall.plane = planeThrough({3, 0, 0}, {-1, 0, 0});
		std::vector<double> along;
		for (int i = 0; i < 25; ++i)
		{
			const double y = test::uniform(random, -6, 6), z = test::uniform(random, 0.6, 1.0);
			wall.inliers_in_robot.push_back(Eigen::Vector3d(3, y, z).cast<float>());
			// Paper eq. 2 written out: |n·w| / |n| of the floor z = 0 is z itself.
			if (std::abs(static_cast<float>(z) - 0.8F) <= 0.05F) along.push_back(static_cast<float>(y));
		}
		EXPECT_EQ(scanGaps(wall, kFloor, 0.8, {}).size(), slowGapCount(along, 0.8, 1.6)) << "run " << run;
	}
}

TEST(DoorGaps, EmptyWallHasNone)
{
	WallPatch wall;
	wall.wall.plane = planeThrough({3, 0, 0}, {-1, 0, 0});
	EXPECT_TRUE(findDoors(wall, kFloor, {}).empty());
}
}  // namespace
}  // namespace explore
