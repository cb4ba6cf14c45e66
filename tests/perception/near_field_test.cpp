#include <explore/perception/near_field.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/analytic_scene.h"

namespace explore
{
namespace
{
const mrpt::poses::CPose3D kMount(0, 0, 0.5, 0, 0, 0);
const Plane kFloor{Eigen::Vector3d::UnitZ(), 0.0};

DepthFrame frameOf(const test::Scene& scene, const test::CameraNoise& noise = {})
{
	return test::renderFrame(scene, {}, kMount, test::xtionIntrinsics(320, 240), noise);
}

TEST(NearField, FloorIsNoObstacleButABoxIs)
{
	test::Scene scene;
	scene.floor(-1, -5, 8, 5).wall({5, -5}, {5, 5}, 2.5);
	const NearField free = nearField(frameOf(scene), kFloor);
	ASSERT_TRUE(free.organised);
	for (const auto& sector : free.sectors) EXPECT_NEAR(sector.nearest_m, 5.0, 0.01);

	scene.box({1.0, 0.30, 0.3}, {0.2, 0.2, 0.6});  // left of the axis
	const NearField boxed = nearField(frameOf(scene), kFloor);
	float nearest = 10;
	for (std::size_t i = 0; i < NearField::kSectors; ++i)
	{
		// Sectors run from left to right.
		EXPECT_TRUE(i < 8 || std::abs(boxed.sectors[i].nearest_m - 5.0F) < 0.01F) << i;
		nearest = std::min(nearest, boxed.sectors[i].nearest_m);
	}
	EXPECT_NEAR(nearest, 0.9, 0.02);
}

TEST(NearField, WithoutAGroundTheFloorCounts)
{
	test::Scene scene;
	scene.floor(-1, -5, 8, 5).wall({5, -5}, {5, 5}, 2.5);
	const NearField field = nearField(frameOf(scene), std::nullopt);
	EXPECT_LT(field.sectors[8].nearest_m, 1.5);
}

TEST(NearField, ShareWithoutReturn)
{
	test::Scene scene;
	scene.wall({3, -5}, {3, 5}, 10).wall({3, -5}, {3, 5}, 10);
	DepthFrame frame = frameOf(scene);
	for (int v = 0; v < 240; ++v)  // the left half of the image measures nothing in its upper quarter
		for (int u = 0; u < 160; ++u)
			if (v < 60) frame.image.depth_m[static_cast<std::size_t>(v * 320 + u)] = 0;
	const NearField field = nearField(frame, std::nullopt);
	// Below the horizon there is no wall at z < 0, so compare left with right.
	EXPECT_NEAR(field.sectors[0].no_return_share - field.sectors[15].no_return_share, 0.25, 0.01);
}

TEST(NearField, FewNoisePixelsAreNoObstacle)
{
	test::Scene scene;
	scene.floor(-1, -5, 8, 5).wall({4, -5}, {4, 5}, 2.5);
	DepthFrame frame = frameOf(scene);
	for (int v = 40; v < 43; ++v) frame.image.depth_m[static_cast<std::size_t>(v * 320 + 100)] = 0.4F;
	for (const auto& sector : nearField(frame, kFloor).sectors) EXPECT_GT(sector.nearest_m, 3.9);
}

TEST(NearField, EmptyImageAndUnorganisedCloud)
{
	DepthFrame frame;
	frame.image.intrinsics = test::xtionIntrinsics(64, 48);
	frame.image.depth_m.assign(64 * 48, 0.0F);
	const NearField dark = nearField(frame, kFloor);
	EXPECT_EQ(dark.valid_pixels, 0U);
	for (const auto& sector : dark.sectors)
	{
		EXPECT_EQ(sector.nearest_m, 0.0F);
		EXPECT_EQ(sector.no_return_share, 1.0F);
	}
	DepthFrame cloud;
	cloud.points_in_camera.push_back({1, 0, 0});
	const NearField unorganised = nearField(cloud, kFloor);
	EXPECT_FALSE(unorganised.organised);
	EXPECT_EQ(unorganised.valid_pixels, 1U);
}

TEST(NearField, WhatStandsTooNearHidesInStripsWithoutAnyReturn)
{
	test::Scene scene;
	scene.floor(-1, -5, 8, 5).wall({5, -5}, {5, 5}, 2.5);
	const NearFieldConfig config;
	const auto hidden = [&](const DepthFrame& frame) { return hiddenNear(frame, nearField(frame, kFloor), config); };
	EXPECT_TRUE(hidden(frameOf(scene)).empty()) << "the floor returns";

	// Somebody at the right, 0.35 m away, taller than what the camera sees: as near as that nothing is measured.
	scene.box({0.45, -0.2, 0.85}, {0.2, 0.2, 1.7});
	DepthFrame frame = frameOf(scene);
	for (float& depth_m : frame.image.depth_m)
		if (depth_m < config.sensor_min_range_m) depth_m = 0;
	const PointCloud points = hidden(frame);
	ASSERT_FALSE(points.empty());
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		EXPECT_NEAR(points[i].x(), config.sensor_min_range_m - 0.05, 1e-6);
		EXPECT_LT(points[i].y(), 0.0F) << "left is positive";
		EXPECT_NEAR(points[i].z(), 0.5, 1e-6);
	}

	frame.image.depth_m.assign(frame.image.depth_m.size(), 0.0F);
	EXPECT_TRUE(hidden(frame).empty()) << "in the dark nothing is known of anything";
}
}  // namespace
}  // namespace explore
