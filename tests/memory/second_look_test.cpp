// Things that leave an open hall are forgotten; things that stay are not.
#include <gtest/gtest.h>

#include <map>

#include "map_scenes.h"

namespace explore
{
namespace
{
/** Floor as far as one sees; the rays above it return nothing. */
test::Scene openHall()
{
	test::Scene hall;
	hall.floor(-2, -20, 30, 20);
	return hall;
}

test::Scene hallWithPerson(double x, double y)
{
	test::Scene hall = openHall();
	hall.box({x, y, 0.85}, {0.3, 0.45, 1.7});
	return hall;
}

constexpr test::CameraNoise kNoise{.axial_scale = 1.0, .max_depth_m = 8.0};

DepthFrame viewFrom(const test::Scene& scene, double x, std::uint32_t seed, double yaw = 0.0)
{
	test::CameraNoise noise = kNoise;
	noise.seed = seed;
	return test::viewOf(scene, {x, 0.0, 0.5, yaw, 0.0, 0.0}, noise, 320);
}

/** Occupied voxels above the floor within a box on it, as high as the camera sees from where it gets to. */
std::ptrdiff_t occupiedIn(const Occupancy& map, double x0, double x1, double y0, double y1)
{
	const VoxelBox box = map.statesIn({Eigen::Vector3d(x0, y0, 0.2), Eigen::Vector3d(x1, y1, 1.5)});
	return std::ranges::count(box.states, VoxelState::occupied);
}

TEST(SecondLook, APersonWhoLeavesAnOpenHallIsForgotten)
{
	Occupancy map({});
	for (std::uint32_t i = 0; i < 30; ++i) map.insert(viewFrom(hallWithPerson(3.0, 0.0), 0.0, i));
	ASSERT_GT(occupiedIn(map, 2.5, 3.5, -0.6, 0.6), 100);
	for (std::uint32_t i = 0; i < 20; ++i) map.insert(viewFrom(openHall(), 0.0, 100 + i));
	EXPECT_EQ(occupiedIn(map, 2.5, 3.5, -0.6, 0.6), 0);
}

TEST(SecondLook, WhatIsForgottenIsUnknownWhereNoRayPassed)
{
	Occupancy map({});
	for (std::uint32_t i = 0; i < 10; ++i) map.insert(viewFrom(hallWithPerson(3.0, 0.0), 0.0, i));
	for (std::uint32_t i = 0; i < 20; ++i) map.insert(viewFrom(openHall(), 0.0, 100 + i));
	EXPECT_EQ(map.stateAt({2.86, 0.0, 1.0}), VoxelState::unknown);
	EXPECT_EQ(map.stateAt({2.5, 0.0, 1.0}), VoxelState::free);
}

TEST(SecondLook, APersonWhoWalksThroughLeavesNoTrail)
{
	Occupancy map({});
	for (std::uint32_t i = 0; i < 60; ++i)  // 1 m/s at 20 Hz, the robot drives on meanwhile
		map.insert(viewFrom(hallWithPerson(3.5, -1.5 + 0.05 * i), 0.01 * i, i));
	for (std::uint32_t i = 0; i < 15; ++i) map.insert(viewFrom(openHall(), 0.6, 100 + i));
	EXPECT_EQ(occupiedIn(map, 2.9, 4.0, -0.8, 0.8), 0);
}

TEST(SecondLook, NeverMeansNever)
{
	OccupancyConfig config;
	config.second_look_range_m = 0.0;
	Occupancy map(config);
	for (std::uint32_t i = 0; i < 30; ++i) map.insert(viewFrom(hallWithPerson(3.0, 0.0), 0.0, i));
	for (std::uint32_t i = 0; i < 20; ++i) map.insert(viewFrom(openHall(), 0.0, 100 + i));
	EXPECT_GT(occupiedIn(map, 2.5, 3.5, -0.6, 0.6), 100);
}

/** A hall with a wall, a post and a table top, all with nothing but the dark behind them. */
test::Scene furnishedHall()
{
	test::Scene hall = openHall();
	hall.wall({3.5, 0.6}, {3.5, 3.0}, 1.2)
	    .box({2.5, -0.5, 0.6}, {0.04, 0.04, 1.2})
	    .box({3.0, 0.0, 0.73}, {0.4, 0.5, 0.04});
	return hall;
}

using Keys = std::vector<octomap::OcTreeKey>;
Keys occupiedAboveFloor(Occupancy& map)
{
	Keys keys;
	const octomap::OcTree& tree = map.tree();
	for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf)
		if (tree.isNodeOccupied(*leaf) && leaf.getZ() > 0.2) keys.push_back(leaf.getKey());
	return keys;
}

std::ptrdiff_t forgotten(const Occupancy& map, const Keys& keys)
{
	return std::ranges::count_if(
	    keys, [&](const octomap::OcTreeKey& key) { return map.stateOf(key) == VoxelState::unknown; });
}

TEST(SecondLook, WhatStandsStillStaysThroughNoiseDropoutAndMotion)
{
	Occupancy map({});
	test::CameraNoise noise = kNoise;
	noise.dropout_share = 0.3;
	Keys standing;
	for (std::uint32_t i = 0; i < 120; ++i)
	{
		noise.seed = i;
		const double t = 0.05 * i;
		map.insert(test::viewOf(furnishedHall(),
		                        {0.8 * std::sin(t), 0.3 * std::cos(0.7 * t), 0.5, 0.3 * std::sin(2.1 * t), 0, 0}, noise,
		                        320));
		if (i == 40) standing = occupiedAboveFloor(map);
	}
	ASSERT_GT(standing.size(), 300U);
	EXPECT_EQ(forgotten(map, standing), 0);
}

float& pixelOf(DepthFrame& frame, int u, int v)
{
	const auto width = static_cast<std::size_t>(frame.image.intrinsics.width_px);
	return frame.image.depth_m[static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u)];
}

/** Blanks what a thing nearer than the sensor's minimum range hides, and the pattern's shadow beside it. */
DepthFrame blanked(DepthFrame frame, int u0, int u1, int v0)
{
	for (int v = v0; v < frame.image.intrinsics.height_px; ++v)
		for (int u = u0; u < u1; ++u) pixelOf(frame, u, v) = 0.0F;
	return frame;
}

TEST(SecondLook, WhatANearThingHidesStays)
{
	Occupancy map({});
	for (std::uint32_t i = 0; i < 20; ++i) map.insert(viewFrom(furnishedHall(), 0.0, i));
	const Keys standing = occupiedAboveFloor(map);
	ASSERT_GT(standing.size(), 300U);
	for (std::uint32_t i = 0; i < 50; ++i) map.insert(blanked(viewFrom(furnishedHall(), 0.0, 100 + i), 0, 320, 0));
	for (std::uint32_t i = 0; i < 50; ++i) map.insert(blanked(viewFrom(furnishedHall(), 0.0, 200 + i), 60, 260, 0));
	EXPECT_EQ(forgotten(map, standing), 0);
}

TEST(SecondLook, WhatLiesInTheShadowOfANearThingStays)
{
	Occupancy map({});
	for (std::uint32_t i = 0; i < 20; ++i) map.insert(viewFrom(furnishedHall(), 0.0, i));
	const Keys standing = occupiedAboveFloor(map);
	test::Scene with_person = furnishedHall();
	with_person.box({1.0, -0.30, 0.85}, {0.2, 0.2, 1.7});
	for (std::uint32_t i = 0; i < 50; ++i)
	{
		DepthFrame frame = viewFrom(with_person, 0.0, 100 + i);
		const CameraIntrinsics& camera = frame.image.intrinsics;
		// Left of each near pixel: f · B · (1/near − 1/far) pixels.
		const DepthImage lit = frame.image;
		for (int v = 0; v < camera.height_px; ++v)
			for (int u = 0; u < camera.width_px; ++u)
				for (int k = 1; k < 24 && u + k < camera.width_px; ++k)
					if (const float near_m = lit.at(u + k, v), far_m = lit.at(u, v);
					    near_m > 0 && far_m > near_m + 0.3F && k <= 0.075 * camera.fx_px * (1 / near_m - 1 / far_m))
						pixelOf(frame, u, v) = 0.0F;
		map.insert(frame);
	}
	EXPECT_EQ(forgotten(map, standing), 0);
}

/** What is forgotten of a person who stood 3 m before the robot, once it looks from elsewhere. */
std::ptrdiff_t forgottenFrom(double x)
{
	Occupancy map({});
	for (std::uint32_t i = 0; i < 20; ++i) map.insert(viewFrom(hallWithPerson(3.0, 0.0), 0.0, i));
	const Keys standing = occupiedAboveFloor(map);
	for (std::uint32_t i = 0; i < 50; ++i) map.insert(viewFrom(openHall(), x, 100 + i));
	return forgotten(map, standing);
}

TEST(SecondLook, WhatReturnedLightFromNearerStays)
{
	EXPECT_EQ(forgottenFrom(-0.6), 0);
}

TEST(SecondLook, WhatReturnedLightAtAnotherPlaceStays)
{
	EXPECT_EQ(forgottenFrom(1.2), 0);
	EXPECT_GT(forgottenFrom(0.5), 100);
}

/** Log-odds of the lowest level's leaves by their keys. */
std::map<std::array<int, 3>, float> logOddsOf(const octomap::OcTree& tree)
{
	std::map<std::array<int, 3>, float> values;
	for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf)
		if (const octomap::OcTreeKey key = leaf.getKey(); leaf.getDepth() == tree.getTreeDepth())
			values[{key[0], key[1], key[2]}] = leaf->getLogOdds();
	return values;
}

TEST(SecondLook, AFrameCountsOnce)
{
	const SensorModel model{OccupancyConfig{}};
	Occupancy map({});
	for (std::uint32_t i = 0; i < 8; ++i) map.insert(viewFrom(hallWithPerson(2.5, 0.0), 0.0, i));
	for (std::uint32_t i = 0; i < 12; ++i)
	{
		const auto before = logOddsOf(map.tree());
		map.insert(viewFrom(hallWithPerson(2.5, 0.03 * i), 0.0, 100 + i));
		for (const auto& [key, after] : logOddsOf(map.tree()))
			if (const auto then = before.find(key); then != before.end())
			{
				ASSERT_GT(after - then->second, model.miss - 1e-5F) << "frame " << i;
			}
	}
}

TEST(SecondLook, WhatStandsBehindOtherThingsOfTheMapStaysAsLongAsThoseDo)
{
	test::Scene panel = openHall();
	panel.box({3.2, 0.0, 0.95}, {0.04, 0.6, 0.5});
	test::Scene hidden = panel;
	hidden.box({2.0, 0.0, 0.85}, {0.04, 0.8, 0.5});
	Occupancy map({});
	for (std::uint32_t i = 0; i < 20; ++i) map.insert(viewFrom(panel, 0.0, i));
	for (std::uint32_t i = 0; i < 20; ++i) map.insert(viewFrom(hidden, 0.0, 100 + i));
	ASSERT_GT(occupiedIn(map, 1.9, 2.1, -0.2, 0.2), 50);
	const std::ptrdiff_t panel_before = occupiedIn(map, 3.0, 3.4, -0.2, 0.2);
	for (std::uint32_t i = 0; i < 14; ++i) map.insert(viewFrom(openHall(), 0.0, 200 + i));
	EXPECT_EQ(occupiedIn(map, 1.9, 2.1, -0.2, 0.2), 0);
	// In the last frames the board is forgotten already; that is long enough for what was hit once or twice only.
	EXPECT_GT(occupiedIn(map, 3.0, 3.4, -0.2, 0.2), panel_before * 8 / 10);
}
}  // namespace
}  // namespace explore
