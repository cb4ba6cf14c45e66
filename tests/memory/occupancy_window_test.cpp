// What is kept at hand makes no difference to the map.
#include <gtest/gtest.h>

#include "map_scenes.h"

namespace explore
{
namespace
{
/** A drive of 12 m through a long corridor and back, with glances aside. */
std::vector<DepthFrame> longDrive()
{
	const test::Scene scene = test::corridorScene(16.0, {2.0, 9.0}, {5.0});
	std::vector<DepthFrame> frames;
	for (int i = 0; i < 32; ++i)
	{
		const double x = i < 16 ? 0.8 * i : 0.8 * (31 - i);
		const double yaw = (i < 16 ? 0.0 : 3.1) + (i % 5 == 0 ? 0.8 : 0.1);
		frames.push_back(
		    test::viewOf(scene, {x, 0.1, 0.6, yaw, 0.05, 0.02},
		                 {.axial_scale = 1.0, .dropout_share = 0.02, .seed = static_cast<std::uint32_t>(i)}, 80));
		frames.back().index = frames.size() - 1;
	}
	return frames;
}

std::string mapOf(const std::vector<DepthFrame>& frames, double window_margin_m)
{
	OccupancyConfig config;
	config.range_m = 3.0;
	config.window_margin_m = window_margin_m;
	Occupancy map(config);
	for (const DepthFrame& frame : frames) map.insert(frame);
	return test::bytesOf(map);
}

TEST(OccupancyWindow, AMovingWindowMakesTheMapOfAHugeOne)
{
	const std::vector<DepthFrame> frames = longDrive();
	EXPECT_EQ(mapOf(frames, 1.25), mapOf(frames, 30.0));
}

TEST(OccupancyWindow, ReadingTheMapInBetweenChangesNothing)
{
	const std::vector<DepthFrame> frames = longDrive();
	OccupancyConfig config;
	config.range_m = 3.0;
	Occupancy map(config);
	for (const DepthFrame& frame : frames)
	{
		map.insert(frame);
		EXPECT_EQ(map.tree().size(), map.tree().calcNumNodes());
	}
	EXPECT_EQ(test::bytesOf(map), mapOf(frames, 1.25));
}

TEST(OccupancyWindow, StatesAreTheSameInsideAndOutside)
{
	const std::vector<DepthFrame> frames = longDrive();
	OccupancyConfig config;
	config.range_m = 3.0;
	Occupancy map(config);
	for (int i = 0; i < 16; ++i) map.insert(frames[static_cast<std::size_t>(i)]);  // the start is out of the window now
	const VoxelBox box = map.statesIn({Eigen::Vector3d(-1, -2, -0.2), Eigen::Vector3d(15, 2, 2.6)});
	const octomap::OcTree& tree = map.tree();
	std::array<std::size_t, 3> count{};
	std::size_t i = 0;  // x runs first, then y, then z
	for (int z = 0; z < box.size.z(); ++z)
		for (int y = 0; y < box.size.y(); ++y)
			for (int x = 0; x < box.size.x(); ++x)
			{
				const auto key = [](int first, int steps) { return static_cast<octomap::key_type>(first + steps); };
				const octomap::OcTreeKey voxel(key(box.first[0], x), key(box.first[1], y), key(box.first[2], z));
				const VoxelState state = box.states[i++];
				const octomap::OcTreeNode* node = tree.search(voxel);
				const VoxelState expected = node == nullptr             ? VoxelState::unknown
				                            : tree.isNodeOccupied(node) ? VoxelState::occupied
				                                                        : VoxelState::free;
				ASSERT_EQ(state, expected);
				ASSERT_EQ(map.stateOf(voxel), expected);
				const octomap::point3d center = tree.keyToCoord(voxel);
				ASSERT_EQ(map.stateAt({center.x(), center.y(), center.z()}), expected);
				++count[static_cast<std::size_t>(state)];
			}
	for (const std::size_t n : count) EXPECT_GT(n, 1000U);
}
}  // namespace
}  // namespace explore
