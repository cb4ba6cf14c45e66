// The map against OctoMap's own insertion of every pixel.
#include <gtest/gtest.h>

#include "map_scenes.h"
#include "support/octomap_peer.h"

namespace explore
{
namespace
{
/** Both maps after the same frames. Points on voxels' faces may be rounded to either side. */
void expectSameMap(const octomap::OcTree& map, const octomap::OcTree& reference, double tolerance)
{
	const test::MapAgreement found = test::agreement(map, reference);
	EXPECT_GT(found.reference_occupied, 500U);
	EXPECT_GT(found.occupiedIou(), 1.0 - tolerance);
	EXPECT_GT(found.freeIou(), 1.0 - tolerance);
	EXPECT_LT(found.wronglyFreedShare(), tolerance);
}

void compare(std::mt19937& random, const OccupancyConfig& config, const test::CameraNoise& noise, int width_px)
{
	const test::Scene room = test::randomRoom(random);
	Occupancy map(config);
	const auto reference = test::peerTree(config);
	for (int i = 0; i < 4; ++i)
	{
		const DepthFrame frame = test::viewOf(room, test::randomView(random), noise, width_px);
		map.insert(frame);
		reference->insertPointCloud(test::cloudInMap(frame), test::cameraInMap(frame), config.range_m);
	}
	expectSameMap(map.tree(), *reference, 0.002);
}

TEST(OccupancyAgainstOctoMap, SameMapFromRandomViewsOfRandomRooms)
{
	std::mt19937 random(7);
	for (std::uint32_t trial = 0; trial < 6; ++trial)
	{
		SCOPED_TRACE(trial);
		compare(random, {}, {.axial_scale = 1.0, .dropout_share = 0.05, .seed = trial}, 160);
	}
}

TEST(OccupancyAgainstOctoMap, SameMapFromFewPixelsAndSmallVoxels)
{
	std::mt19937 random(8);
	OccupancyConfig config;
	config.resolution_m = 0.03;
	config.range_m = 3.0;
	compare(random, config, {.axial_scale = 1.0, .dropout_share = 0.3}, 64);
}

TEST(OccupancyAgainstOctoMap, SameMapWithAnotherSensorModel)
{
	std::mt19937 random(9);
	OccupancyConfig config;
	config.resolution_m = 0.1;
	config.hit_probability = 0.8;
	config.miss_probability = 0.45;
	config.min_probability = 0.2;
	config.max_probability = 0.9;
	compare(random, config, {.axial_scale = 1.0}, 160);
}

TEST(OccupancyAgainstOctoMap, LogOddsAreTheSameToTheLastBit)
{
	std::mt19937 random(10);
	const test::Scene room = test::randomRoom(random);
	const OccupancyConfig config;
	Occupancy map(config);
	const auto reference = test::peerTree(config);
	const mrpt::poses::CPose3D view = test::randomView(random);
	for (std::uint32_t i = 0; i < 8; ++i)  // more than it takes to get from one end to the other
	{
		const DepthFrame frame = test::viewOf(room, view, {.axial_scale = 1.0, .seed = i});
		map.insert(frame);
		reference->insertPointCloud(test::cloudInMap(frame), test::cameraInMap(frame), config.range_m);
	}
	std::size_t same = 0, different = 0;
	const octomap::OcTree& tree = map.tree();
	for (auto leaf = reference->begin_leafs(); leaf != reference->end_leafs(); ++leaf)
	{
		const octomap::OcTreeNode* node = tree.search(leaf.getKey());
		(node != nullptr && node->getLogOdds() == leaf->getLogOdds() ? same : different) += 1;
	}
	EXPECT_LT(different, same / 500);
}
}  // namespace
}  // namespace explore
