#include <explore/core/errors.h>
#include <explore/memory/occupancy.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "map_scenes.h"

namespace explore
{
namespace
{
const mrpt::poses::CPose3D kCamera(0.02, 0.03, 0.51, 0, 0, 0);

TEST(Occupancy, KnowsWhatIsFreeOccupiedAndHidden)
{
	test::Scene scene;
	scene.floor(-1, -5, 8, 5).wall({3.03, -5}, {3.03, 5}, 2.5);
	Occupancy map({});
	EXPECT_EQ(map.stateAt({1, 0, 0.5}), VoxelState::unknown);
	map.insert(test::viewOf(scene, kCamera));
	EXPECT_EQ(map.stateAt({1, 0, 0.5}), VoxelState::free);
	EXPECT_EQ(map.stateAt({2.9, 0.5, 0.5}), VoxelState::free);
	EXPECT_EQ(map.stateAt({3.03, 0.5, 0.5}), VoxelState::occupied);
	EXPECT_EQ(map.stateAt({3.3, 0.5, 0.5}), VoxelState::unknown);
	EXPECT_EQ(map.stateAt({-1, 0, 0.5}), VoxelState::unknown);
	EXPECT_EQ(map.stateAt({1e9, 0, 0.5}), VoxelState::unknown);
}

TEST(Occupancy, BeyondTheRangeItIsFreeUpToTheRangeAndNothingIsOccupied)
{
	test::Scene scene;
	scene.wall({7, -9}, {7, 9}, 3.0);
	Occupancy map({});
	map.insert(test::viewOf(scene, kCamera));
	EXPECT_EQ(map.stateAt({4.9, 0.1, 0.5}), VoxelState::free);
	EXPECT_EQ(map.stateAt({5.2, 0.1, 0.5}), VoxelState::unknown);
	for (const VoxelChange& change : map.changes()) EXPECT_EQ(change.after, VoxelState::free);
	// The range is along the ray: in the image's corner its depth is less.
	const double half_width = 0.9 / (2 * 0.919);
	EXPECT_EQ(map.stateAt(Eigen::Vector3d(0.02, 0.03, 0.51) + 4.9 * Eigen::Vector3d(1, half_width, 0)),
	          VoxelState::unknown);
}

TEST(Occupancy, NoReturnSaysNothing)
{
	Occupancy map({});
	map.insert(test::viewOf({}, kCamera));
	EXPECT_TRUE(map.changes().empty());
	EXPECT_EQ(map.tree().size(), 0U);
	map.insert({});
	EXPECT_TRUE(map.changes().empty());
}

TEST(Occupancy, KeepsAThinPoleThatRaysPassOnBothSides)
{
	test::Scene scene;
	scene.floor(-1, -5, 8, 5).wall({4.5, -5}, {4.5, 5}, 2.5).box({3.0, 0.0, 0.5}, {0.02, 0.02, 1.0});
	Occupancy map({});
	for (std::uint32_t i = 0; i < 60; ++i)
		map.insert(test::viewOf(scene, {0.01 * i, 0.1, 0.5, 0.05, 0, 0},
		                        {.axial_scale = 0.3, .dropout_share = 0.1, .seed = i}, 320));
	int occupied = 0;
	for (double z = 0.2; z < 0.9; z += 0.05)
	{
		const VoxelBox around = map.statesIn({Eigen::Vector3d(2.95, -0.05, z), Eigen::Vector3d(3.05, 0.05, z)});
		occupied += static_cast<int>(std::ranges::count(around.states, VoxelState::occupied) > 0);
	}
	EXPECT_EQ(occupied, 14);
}

TEST(Occupancy, AnOpenedDoorIsFreeAfterAFewFrames)
{
	test::Scene closed, open;
	for (test::Scene* scene : {&closed, &open}) scene->floor(-1, -5, 8, 5).wall({4.5, -5}, {4.5, 5}, 2.5);
	closed.box({2.0, 0.0, 1.0}, {0.05, 1.0, 2.0});
	Occupancy map({});
	for (int i = 0; i < 20; ++i) map.insert(test::viewOf(closed, kCamera));
	EXPECT_EQ(map.stateAt({1.98, 0.0, 0.5}), VoxelState::occupied);
	for (int i = 0; i < 10; ++i) map.insert(test::viewOf(open, kCamera));
	EXPECT_EQ(map.stateAt({1.98, 0.0, 0.5}), VoxelState::free);
}

TEST(Occupancy, ChangesAddUpToTheMap)
{
	std::mt19937 random(11);
	const test::Scene room = test::randomRoom(random);
	Occupancy map({});
	std::map<std::array<int, 3>, VoxelState> states;
	for (std::uint32_t i = 0; i < 8; ++i)
	{
		map.insert(test::viewOf(room, test::randomView(random), {.axial_scale = 1.0, .seed = i}));
		std::map<std::array<int, 3>, VoxelState> now;
		for (const VoxelChange& change : map.changes())
		{
			const std::array<int, 3> key{change.key[0], change.key[1], change.key[2]};
			const auto before = states.find(key);
			ASSERT_EQ(change.before, before == states.end() ? VoxelState::unknown : before->second);
			ASSERT_NE(change.before, change.after);
			ASSERT_EQ(map.stateOf(change.key), change.after);
			ASSERT_TRUE(now.emplace(key, change.after).second) << "twice";
		}
		for (const auto& [key, state] : now) states[key] = state;
	}
	std::size_t known = 0;
	const octomap::OcTree& tree = map.tree();
	for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf)
	{
		const std::size_t edge = std::size_t{1} << (16U - leaf.getDepth());
		known += edge * edge * edge;
		const octomap::OcTreeKey key = leaf.getIndexKey();
		const VoxelState state = tree.isNodeOccupied(*leaf) ? VoxelState::occupied : VoxelState::free;
		const std::array<int, 3> place{key[0], key[1], key[2]};
		ASSERT_EQ(states.at(place), state);
	}
	EXPECT_EQ(known, states.size());
}

TEST(Occupancy, GoesOnWithAnOlderMap)
{
	std::mt19937 random(12);
	const test::Scene room = test::randomRoom(random);
	std::vector<DepthFrame> frames;
	for (std::uint32_t i = 0; i < 8; ++i)
		frames.push_back(test::viewOf(room, test::randomView(random), {.axial_scale = 1.0, .seed = i}));
	Occupancy whole({}), yesterday({});
	for (const DepthFrame& frame : frames) whole.insert(frame);
	for (int i = 0; i < 4; ++i) yesterday.insert(frames[static_cast<std::size_t>(i)]);

	std::stringstream file(test::bytesOf(yesterday));
	std::unique_ptr<octomap::OcTree> read(dynamic_cast<octomap::OcTree*>(octomap::AbstractOcTree::read(file)));
	ASSERT_NE(read, nullptr);
	Occupancy today({}, std::move(read));
	EXPECT_TRUE(today.changes().empty());
	for (int i = 4; i < 8; ++i) today.insert(frames[static_cast<std::size_t>(i)]);
	EXPECT_EQ(test::bytesOf(today), test::bytesOf(whole));

	EXPECT_THROW(Occupancy({}, std::make_unique<octomap::OcTree>(0.1)), ConfigError);
}

TEST(Occupancy, RefusesPosesThatTheMapCannotHold)
{
	test::Scene scene;
	scene.wall({3, -5}, {3, 5}, 2.5);
	Occupancy map({});
	for (const double x :
	     {1e5, -1700.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
	{
		DepthFrame frame = test::viewOf(scene, kCamera);
		frame.map_from_robot.x(x);
		EXPECT_THROW(map.insert(frame), InputError) << x;
	}
	EXPECT_EQ(map.tree().size(), 0U);
	DepthFrame frame = test::viewOf(scene, {1600, -1600, 0, 0, 0, 0});
	map.insert(test::viewOf(scene, kCamera));
	EXPECT_FALSE(map.changes().empty());
}

TEST(Occupancy, SensorModelGoesWithTheTree)
{
	OccupancyConfig config;
	config.hit_probability = 0.8;
	config.min_probability = 0.2;
	Occupancy map(config);
	EXPECT_NEAR(map.tree().getProbHit(), 0.8, 1e-6);
	EXPECT_NEAR(map.tree().getClampingThresMin(), 0.2, 1e-6);
}
}  // namespace
}  // namespace explore
