#include <explore/memory/block_tree.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "support/random_points.h"

namespace explore
{
namespace
{
using Tree = octomap::OcTree;
constexpr double kEdge_m = 0.1;

/** Blocks of few different values, so that much of them can be pruned, some voxels unknown, some blocks wholly. */
BlockValues randomBlock(std::mt19937& random)
{
	BlockValues values{};
	const unsigned kind = random() % 4;
	for (std::size_t i = 0; i < values.size(); ++i)
	{
		const bool coarse = kind == 1;
		const unsigned roll = kind == 2 ? random() % 20 : (coarse ? static_cast<unsigned>(i / 64) : 0U);
		values[i] = kind == 3 ? kUnknown : (roll == 0 ? -2.0F : (roll % 3 == 1 ? 0.5F : kUnknown));
	}
	return values;
}

GridKey randomKey(std::mt19937& random)
{
	const auto near_origin = [&] { return kOriginKey / kBlockEdge - 2 + static_cast<int>(random() % 4); };
	return {near_origin(), near_origin(), near_origin()};
}

octomap::OcTreeKey voxelKey(const GridKey& block, int place)
{
	const auto [x, y, z] = coordinatesOfPlace(place);
	const GridKey voxel = block * kBlockEdge + GridKey(x, y, z);
	const auto key = [](int i) { return static_cast<octomap::key_type>(i); };
	return {key(voxel.x()), key(voxel.y()), key(voxel.z())};
}

std::string bytesOf(const Tree& tree)
{
	std::ostringstream bytes;
	tree.write(bytes);
	return bytes.str();
}

using Blocks = std::map<std::array<int, 3>, BlockValues>;

/** The same map made with OctoMap's own functions, voxel by voxel. */
Tree slowTree(const Blocks& blocks)
{
	Tree tree(kEdge_m);
	for (const auto& [at, values] : blocks)
		for (int place = 0; place < kBlockVoxels; ++place)
			if (const float value = values[static_cast<std::size_t>(place)]; !std::isnan(value))
				tree.setNodeValue(voxelKey({at[0], at[1], at[2]}, place), value, true);
	tree.updateInnerOccupancy();
	tree.prune();
	return tree;
}

TEST(BlockTree, IsTheTreeThatOctoMapMakesVoxelByVoxel)
{
	std::mt19937 random(1);
	for (int trial = 0; trial < 20; ++trial)
	{
		Tree tree(kEdge_m);
		Blocks blocks;
		for (int i = 0; i < 30; ++i)  // several of them again and again
		{
			const GridKey key = randomKey(random);
			const BlockValues values = randomBlock(random);
			writeBlock(tree, key, values);
			blocks[{key.x(), key.y(), key.z()}] = values;
			if (random() % 3 == 0) updateInnerNodes(tree);
		}
		updateInnerNodes(tree);
		EXPECT_EQ(bytesOf(tree), bytesOf(slowTree(blocks))) << "trial " << trial;
		EXPECT_EQ(tree.size(), tree.calcNumNodes());
	}
}

TEST(BlockTree, ReadsWhatTheTreeAnswersVoxelByVoxel)
{
	std::mt19937 random(2);
	Blocks blocks;
	for (int i = 0; i < 12; ++i)
	{
		const GridKey key = randomKey(random);
		blocks[{key.x(), key.y(), key.z()}] = randomBlock(random);
	}
	const Tree tree = slowTree(blocks);
	for (int i = 0; i < 30; ++i)
	{
		const GridKey key = randomKey(random);
		const BlockValues values = readBlock(tree, key);
		for (int place = 0; place < kBlockVoxels; ++place)
		{
			const float value = values[static_cast<std::size_t>(place)];
			const octomap::OcTreeNode* node = tree.search(voxelKey(key, place));
			ASSERT_EQ(std::isnan(value), node == nullptr);
			if (node != nullptr)
			{
				ASSERT_EQ(value, node->getLogOdds());
			}
		}
	}
}

TEST(BlockTree, WritesIntoAPrunedRegion)
{
	Tree tree(kEdge_m);
	BlockValues values{};
	values.fill(1.5F);
	for (int place = 0; place < 8; ++place)
	{
		const auto [x, y, z] = coordinatesOfPlace(place);
		writeBlock(tree, GridKey(kOriginKey / 8 + x, kOriginKey / 8 + y, kOriginKey / 8 + z), values);
	}
	updateInnerNodes(tree);
	const std::size_t pruned_size = tree.size();
	values[5] = kUnknown;
	writeBlock(tree, GridKey::Constant(kOriginKey / 8), values);
	updateInnerNodes(tree);
	EXPECT_GT(tree.size(), pruned_size);
	EXPECT_TRUE(std::isnan(readBlock(tree, GridKey::Constant(kOriginKey / 8))[5]));
	EXPECT_EQ(readBlock(tree, GridKey::Constant(kOriginKey / 8 + 1))[5], 1.5F);
}

TEST(BlockTree, NothingIsLeftOfAMapThatBecomesUnknown)
{
	Tree tree(kEdge_m);
	BlockValues values{};
	values.fill(1.5F);
	writeBlock(tree, GridKey::Constant(4096), values);
	values.fill(kUnknown);
	writeBlock(tree, GridKey::Constant(4097), values);  // was unknown before
	EXPECT_EQ(readBlock(tree, GridKey::Constant(4096))[0], 1.5F);
	writeBlock(tree, GridKey::Constant(4096), values);
	EXPECT_EQ(tree.size(), 0U);
	EXPECT_TRUE(std::isnan(readBlock(tree, GridKey::Constant(4096))[0]));
}
}  // namespace
}  // namespace explore
