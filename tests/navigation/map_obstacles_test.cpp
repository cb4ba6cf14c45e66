#include <explore/navigation/map_obstacles.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/drawn_map.h"

namespace explore
{
namespace
{
/** The robot stands at `r`; 0.1 m a character. */
const test::DrawnMap kCorner({"??????????????????????????????",  //
                              "#.............................",  //
                              "#.............................",  //
                              "#.............................",  //
                              "#...............vv............",  //
                              "#...............vv............",  //
                              "#......r......................",  //
                              "#.............................",  //
                              "#.............................",  //
                              "#......##.....................",  //
                              "#......##.....................",  //
                              "##############################"},
                             0.1);

Eigen::Isometry3d poseAt(const Eigen::Vector3d& place, double yaw_rad)
{
	Eigen::Isometry3d map_from_robot = Eigen::Isometry3d::Identity();
	map_from_robot.translate(place).rotate(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
	return map_from_robot;
}

/** Distance of the nearest point to where `point_in_map` is seen from the robot, on the plan. */
double nearestTo(const PointCloud& points, const Eigen::Isometry3d& map_from_robot, const Eigen::Vector3d& point_in_map)
{
	double nearest_m = 1e3;
	for (std::size_t i = 0; i < points.size(); ++i)
		nearest_m = std::min(nearest_m, (map_from_robot * points[i].cast<double>() - point_in_map).head<2>().norm());
	return nearest_m;
}

TEST(MapObstacles, AreWhatTheMapHasAroundTheRobotWhereverItLooks)
{
	for (const double yaw_rad : {0.0, 1.0, -2.5})
	{
		const Eigen::Isometry3d map_from_robot = poseAt(kCorner.at('r'), yaw_rad);
		const PointCloud points = mapObstacles(test::layersOf(kCorner), map_from_robot, {}, 1.5);
		EXPECT_LT(nearestTo(points, map_from_robot, {0.05, 0.55, 0}), 0.04) << "the wall behind";
		EXPECT_LT(nearestTo(points, map_from_robot, {0.75, 0.25, 0}), 0.04) << "the box";
		EXPECT_LT(nearestTo(points, map_from_robot, {1.65, 0.75, 0}), 0.04) << "the drop";
		EXPECT_LT(nearestTo(points, map_from_robot, {0.75, 1.125, 0}), 0.04) << "the edge of what is known";
		EXPECT_GT(nearestTo(points, map_from_robot, {1.25, 0.55, 0}), 0.3) << "free floor";
		EXPECT_GT(nearestTo(points, map_from_robot, {2.55, 0.05, 0}), 0.2) << "too far";
		EXPECT_GT(nearestTo(points, map_from_robot, {0.75, 1.175, 0}), 0.04) << "unknown beyond the edge";
		const PointCloud seen = mapObstacles(test::layersOf(kCorner), map_from_robot, {}, 1.5, false);
		EXPECT_GT(nearestTo(seen, map_from_robot, {0.75, 1.125, 0}), 0.2) << "the unknown does not count";
		EXPECT_LT(nearestTo(seen, map_from_robot, {0.05, 0.55, 0}), 0.04) << "the wall does";
	}
}

TEST(MapObstacles, LieWithinTheBodysHeight)
{
	const PointCloud points = mapObstacles(test::layersOf(kCorner), poseAt(kCorner.at('r'), 0.3), {}, 1.5);
	ASSERT_GT(points.size(), 50U);
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		EXPECT_GT(points[i].z(), 0.1F);
		EXPECT_LT(points[i].z(), 0.6F);
	}
}

TEST(MapObstacles, UnknownSpaceThatTheBodyTouchesDoesNotHoldItButThingsDo)
{
	// Where the robot stands is known, and no more.
	const test::DrawnMap island(
	    {"?????????", "?...#...?", "?.......?", "?...r...?", "?.......?", "?.......?", "?????????"}, 0.1);
	const Eigen::Isometry3d map_from_robot = poseAt(island.at('r'), 0.0);
	const PointCloud points = mapObstacles(test::layersOf(island), map_from_robot, {}, 1.0);
	EXPECT_LT(nearestTo(points, map_from_robot, island.at('#')), 0.04);
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		const double away_m = points[i].head<2>().norm();
		const bool thing = (map_from_robot * points[i].cast<double>() - island.at('#')).head<2>().norm() < 0.08;
		EXPECT_TRUE(thing || away_m > 0.22 + 0.1) << away_m;
	}
}

TEST(MapObstacles, OfAMavAreThoseOfItsLayer)
{
	RobotConfig mav;
	mav.kind = RobotKind::mav;
	mav.height_m = 0.25;
	const Eigen::Vector3d at(1.0, 0.6, 1.25);
	const PointCloud points = mapObstacles(test::layersOf(kCorner, mav), poseAt(at, 0.0), mav, 1.5);
	ASSERT_GT(points.size(), 20U);
	for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(points[i].z(), 0.0F, 1e-6F) << "at its altitude";
	EXPECT_LT(nearestTo(points, poseAt(at, 0.0), {0.75, 0.25, 0}), 0.04);
}

TEST(MapObstacles, AreNoneInAnEmptyMap)
{
	EXPECT_EQ(mapObstacles(BodyLayers({}, {}, 0.05), poseAt({0, 0, 0}, 0), {}, 2.0).size(), 0U);
}
}  // namespace
}  // namespace explore
