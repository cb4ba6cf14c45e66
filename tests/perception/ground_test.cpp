#include <explore/core/geometry.h>
#include <explore/perception/ground.h>
#include <gtest/gtest.h>

#include "support/random_points.h"

namespace explore
{
namespace
{
std::optional<FoundPlane> ground(const PointCloud& points, const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ())
{
	RandomEngine engine(1);
	return findGround(points, {up, {0, 0, 0.5}}, {}, {}, engine);
}

TEST(Ground, LowestOfFloorTableAndCeiling)
{
	std::mt19937 random(1);
	PointCloud points;
	test::addPatch(points, {1, -2, 2.5}, {4, 0, 0}, {0, 4, 0}, 0.05, 0.005, random);   // ceiling: the largest
	test::addPatch(points, {1, -1, 0.75}, {2, 0, 0}, {0, 2, 0}, 0.05, 0.005, random);  // table
	test::addPatch(points, {1, -1, 0}, {1, 0, 0}, {0, 1.5, 0}, 0.05, 0.005, random);   // floor: the smallest
	const auto found = ground(points);
	ASSERT_TRUE(found);
	EXPECT_NEAR(found->plane.d_m, 0.0, 0.01);
	EXPECT_GT(found->plane.normal.z(), 0.999);
	EXPECT_NEAR(static_cast<double>(found->inliers.size()), 20 * 30, 0.1 * 20 * 30);
}

TEST(Ground, TiltUpToFifteenDegreesIsAccepted)
{
	std::mt19937 random(2);
	for (const double tilt_deg : {-17.0, -13.0, 0.0, 13.0, 17.0})
	{
		PointCloud points;
		const Eigen::AngleAxisd tilt(tilt_deg * kDegree_rad, Eigen::Vector3d::UnitY());
		test::addPatch(points, {0, -1, 0}, tilt * Eigen::Vector3d(2, 0, 0), {0, 2, 0}, 0.05, 0.005, random);
		EXPECT_EQ(ground(points).has_value(), std::abs(tilt_deg) < 15) << tilt_deg << " deg";
	}
}

TEST(Ground, VerticalOfTheImuReplacesTheRobots)
{
	std::mt19937 random(3);
	PointCloud points;
	const Eigen::AngleAxisd tilt(30 * kDegree_rad, Eigen::Vector3d::UnitX());
	test::addPatch(points, tilt * Eigen::Vector3d(0, -1, 0), {2, 0, 0}, tilt * Eigen::Vector3d(0, 2, 0), 0.05, 0.005,
	               random);
	EXPECT_FALSE(ground(points));
	const auto found = ground(points, tilt * Eigen::Vector3d::UnitZ());
	ASSERT_TRUE(found);
	EXPECT_LT(angleBetweenAxes(found->plane.normal, tilt * Eigen::Vector3d::UnitZ()), 0.01);
}

TEST(Ground, SliceThroughWallsIsNoFloor)
{
	std::mt19937 random(4);
	PointCloud points;  // three walls of a room corner, no floor in view
	test::addPatch(points, {3, -2, 0.4}, {0, 4, 0}, {0, 0, 2}, 0.05, 0.01, random);
	test::addPatch(points, {1, 2, 0.4}, {2, 0, 0}, {0, 0, 2}, 0.05, 0.01, random);
	test::addPatch(points, {1, -2, 0.4}, {2, 0, 0}, {0, 0, 2}, 0.05, 0.01, random);
	EXPECT_FALSE(ground(points));
}

TEST(Ground, NarrowFloorBeforeAWallIsFound)
{
	std::mt19937 random(5);
	PointCloud points;
	test::addPatch(points, {1.5, -1, 0}, {0, 2, 0}, {0, 0, 1.5}, 0.05, 0.01, random);
	test::addPatch(points, {1.1, -1, 0}, {0.4, 0, 0}, {0, 2, 0}, 0.05, 0.01, random);
	const auto found = ground(points);
	ASSERT_TRUE(found);
	EXPECT_GT(found->plane.normal.z(), 0.995);
	EXPECT_NEAR(found->plane.d_m, 0.0, 0.05);
}

TEST(Ground, StrayReturnsFromBelowTheFloorAreNoFloor)
{
	std::mt19937 random(8);
	PointCloud points;
	test::addPatch(points, {0.5, -2, 0}, {4, 0, 0}, {0, 4, 0}, 0.05, 0.01, random);
	// Reflections on a shiny floor: a tilted sheet, and a level one that is small.
	test::addPatch(points, {2, -1, -0.6}, {1, 0, 0.15}, {0, 1, 0}, 0.05, 0.01, random);
	test::addPatch(points, {2, 0.5, -0.9}, {0.5, 0, 0}, {0, 0.6, 0}, 0.05, 0.01, random);
	const auto found = ground(points);
	ASSERT_TRUE(found);
	EXPECT_NEAR(found->plane.d_m, 0.0, 0.01);
}

TEST(Ground, PlaneAtOrAboveTheCameraIsNone)
{
	std::mt19937 random(7);
	PointCloud points;
	test::addPatch(points, {1, -1, 1.2}, {2, 0, 0}, {0, 2, 0}, 0.05, 0.005, random);  // a shelf above
	EXPECT_FALSE(ground(points));
	test::addPatch(points, {1, -1, 0.48}, {2, 0, 0}, {0, 2, 0}, 0.05, 0.005, random);  // a seat at its height
	EXPECT_FALSE(ground(points));
	test::addPatch(points, {1, -1, 0.1}, {2, 0, 0}, {0, 2, 0}, 0.05, 0.005, random);
	EXPECT_TRUE(ground(points));
}

TEST(Ground, NoneInAnEmptyCloudOrClutter)
{
	std::mt19937 random(6);
	PointCloud points;
	EXPECT_FALSE(ground(points));
	test::addUniform(points, 3000, 2.0, random);
	EXPECT_FALSE(ground(points));
}
}  // namespace
}  // namespace explore
