// What stood near a moment ago is remembered until it is seen through, or old.
#include <explore/core/geometry.h>
#include <explore/memory/recent_obstacles.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/drawn_map.h"

namespace explore::test
{
namespace
{
constexpr int kWidth_px = 80, kHeight_px = 60;

/** A frame of a camera at the robot's origin that measures `depth_m` everywhere. */
DepthFrame frameAt(double t_s, double depth_m, const mrpt::poses::CPose3D& map_from_robot = {})
{
	DepthFrame frame;
	frame.timestamp = mrpt::Clock::fromDouble(t_s);
	frame.image.intrinsics = {kWidth_px, kHeight_px, 70, 70, 39.5, 29.5};
	frame.image.depth_m.assign(static_cast<std::size_t>(kWidth_px) * kHeight_px, static_cast<float>(depth_m));
	frame.map_from_robot = map_from_robot;
	return frame;
}

PointCloud only(const Eigen::Vector3f& point)
{
	PointCloud points;
	points.push_back(point);
	return points;
}

const RobotConfig kRobot;
const BodyLayers kUnknown({}, kRobot, 0.05);
const Eigen::Vector3f kThing{0.6F, 0.1F, 0.05F};

std::size_t left(const RecentObstacles& recent)
{
	return inRobotFrame(recent, Eigen::Isometry3d::Identity()).size();
}
}  // namespace

TEST(RecentObstacles, WhatComesTooNearToBeMeasuredStays)
{
	RecentObstacles recent;
	update(recent, frameAt(100, 0.6), only(kThing), kUnknown, kRobot);
	// It has come under the sensor's range: nothing is measured where it stands.
	update(recent, frameAt(101, 0.0), {}, kUnknown, kRobot);
	const PointCloud known = inRobotFrame(recent, Eigen::Isometry3d::Identity());
	ASSERT_EQ(known.size(), 1U);
	EXPECT_LT((known[0] - kThing).norm(), 1e-6F);
}

TEST(RecentObstacles, WhatTurnsOutOfViewStaysWhereItWas)
{
	RecentObstacles recent;
	update(recent, frameAt(100, 0.6), only(kThing), kUnknown, kRobot);
	const mrpt::poses::CPose3D turned(0.1, 0.0, 0.0, M_PI / 2, 0.0, 0.0);
	update(recent, frameAt(101, 4.0, turned), {}, kUnknown, kRobot);
	const PointCloud known = inRobotFrame(recent, isometryOf(turned));
	ASSERT_EQ(known.size(), 1U);
	EXPECT_LT((known[0] - Eigen::Vector3f(0.1F, -0.5F, 0.05F)).norm(), 1e-6F);
}

TEST(RecentObstacles, WhatIsSeenThroughIsForgottenWhatIsHiddenIsNot)
{
	RecentObstacles recent;
	update(recent, frameAt(100, 0.6), only(kThing), kUnknown, kRobot);
	update(recent, frameAt(100.1, 0.5), {}, kUnknown, kRobot);
	EXPECT_EQ(left(recent), 1U) << "something else stands before it";
	update(recent, frameAt(100.2, 2.0), {}, kUnknown, kRobot);
	EXPECT_EQ(left(recent), 0U);
}

TEST(RecentObstacles, WhatIsOldIsForgotten)
{
	RecentObstacles recent;
	update(recent, frameAt(100, 0.6), only(kThing), kUnknown, kRobot);
	update(recent, frameAt(109.9, 0.0), {}, kUnknown, kRobot);
	EXPECT_EQ(left(recent), 1U);
	update(recent, frameAt(110.1, 0.0), {}, kUnknown, kRobot);
	EXPECT_EQ(left(recent), 0U);
}

TEST(RecentObstacles, OnlyWhatIsNearCountsAndEachColumnOnce)
{
	PointCloud points = only(kThing);
	points.push_back({0.6F, 0.1F, 0.3F});
	points.push_back({2.0F, 0.0F, 0.1F});
	RecentObstacles ground, mav;
	update(ground, frameAt(100, 0.0), points, kUnknown, kRobot);
	EXPECT_EQ(left(ground), 1U);
	RobotConfig flying = kRobot;
	flying.kind = RobotKind::mav;
	update(mav, frameAt(100, 0.0), points, kUnknown, flying);
	EXPECT_EQ(left(mav), 2U) << "what flies passes above and below things";
}

TEST(RecentObstacles, WhatCameIntoFreeSpaceHasABodyBehindItsFront)
{
	const DrawnMap open_floor(std::vector<std::string>(60, std::string(60, '.')));
	const Eigen::Vector3d at = open_floor.middleOf(20, 30);
	const mrpt::poses::CPose3D pose(at.x(), at.y(), 0, 0, 0, 0);
	const auto behind = [](const RecentObstacles& recent, const mrpt::poses::CPose3D& map_from_robot)
	{
		float farthest_m = 0;
		const PointCloud known = inRobotFrame(recent, isometryOf(map_from_robot));
		for (std::size_t i = 0; i < known.size(); ++i) farthest_m = std::max(farthest_m, known[i].x() - kThing.x());
		return farthest_m;
	};
	RecentObstacles person, wall;
	const BodyLayers free = layersOf(open_floor), unknown = BodyLayers({}, kRobot, 0.05);
	update(person, frameAt(100, 0.6, pose), only(kThing), free, kRobot);
	update(wall, frameAt(100, 0.6, pose), only(kThing), unknown, kRobot);
	EXPECT_NEAR(behind(person, pose), 0.3, 0.02);
	EXPECT_NEAR(behind(wall, pose), 0.0, 1e-6);
	// When the map has come to know its front, its body is still there as long as the front is seen.
	for (int second = 1; second < 30; ++second)
		update(person, frameAt(100 + second, 0.6, pose), only(kThing), unknown, kRobot);
	EXPECT_NEAR(behind(person, pose), 0.3, 0.02);
}

TEST(RecentObstacles, ACloudForgetsByAgeAlone)
{
	RecentObstacles recent;
	update(recent, frameAt(100, 0.6), only(kThing), kUnknown, kRobot);
	DepthFrame cloud = frameAt(101, 0.0);
	cloud.image = {};
	cloud.points_in_camera.push_back({3.0F, 0.5F, 0.0F});
	update(recent, cloud, {}, kUnknown, kRobot);
	EXPECT_EQ(left(recent), 1U);
}
}  // namespace explore::test
