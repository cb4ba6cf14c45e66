#include <explore/config/ini.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "frontier_reference.h"
#include "layer_reference.h"
#include "random_voxels.h"

namespace explore
{
namespace
{
constexpr double kResolution_m = 0.05;

class FrontiersOf : public testing::TestWithParam<RobotKind>
{
};

/** Few changes at a time as from frame to frame, then many, in a rectangle that grows. */
TEST_P(FrontiersOf, AreAsIfWorkedOutAnewAfterEveryChange)
{
	BodyLayersConfig small_steps;
	small_steps.growth_m = 0.5;
	for (std::uint32_t seed = 1; seed <= 4; ++seed)
	{
		SCOPED_TRACE(seed);
		test::RandomVoxels voxels(seed);
		BodyLayers layers(small_steps, test::robotOf(GetParam()), kResolution_m);
		Frontiers frontiers({.max_length_m = 0.4});
		for (int i = 0; i < 25; ++i)
		{
			const int count = i % 6 == 0 ? 3000 : 1 << (i % 6 + 2);
			voxels.change(count, {i / 8 * 17, i / 8 * -11, 0});
			if (i % 7 == 3) layers.stood({0.04 * i, -0.03 * i, 1.0});
			layers.update(voxels.changes());
			frontiers.update(layers);
			test::expectUpToDate(frontiers, layers, 0.4);
			if (testing::Test::HasFailure()) return;
		}
		EXPECT_GT(frontiers.clusters().size(), 50U) << "the test saw too little";
	}
}

INSTANTIATE_TEST_SUITE_P(Robots, FrontiersOf, testing::Values(RobotKind::ground, RobotKind::mav),
                         [](const auto& tested) { return std::string(nameOf(tested.param)); });

TEST(Frontiers, NoticeUpdatesThatTheyMissed)
{
	test::RandomVoxels voxels(5);
	BodyLayers layers({}, {}, kResolution_m);
	Frontiers frontiers;
	for (int i = 0; i < 6; ++i)
	{
		voxels.change(4000);
		layers.update(voxels.changes());
		if (i % 3 == 2) frontiers.update(layers);
	}
	test::expectUpToDate(frontiers, layers, 1.5);
	frontiers.update(layers);
	test::expectUpToDate(frontiers, layers, 1.5);
	layers.rebuild(voxels.map());
	frontiers.update(layers);
	test::expectUpToDate(frontiers, layers, 1.5);
}

/** Makes rectangles of cells free or occupied; from … to in cells, ends included. */
std::vector<VoxelChange> cells(const Eigen::Vector2i& from, const Eigen::Vector2i& to, VoxelState state)
{
	std::vector<VoxelChange> changes;
	const auto number = [](int i) { return static_cast<octomap::key_type>(kOriginKey + i); };
	for (int y = from.y(); y <= to.y(); ++y)
		for (int x = from.x(); x <= to.x(); ++x)
			changes.push_back({{number(x), number(y), number(6)}, VoxelState::unknown, state});
	return changes;
}

TEST(Frontiers, ALongFrontIsCutAndPointsOutward)
{
	BodyLayers layers({}, {}, kResolution_m);
	// 4 m of free space, walls to the left, to the right and behind.
	layers.update(cells({0, 0}, {79, 39}, VoxelState::free));
	layers.update(cells({-1, -1}, {-1, 40}, VoxelState::occupied));
	layers.update(cells({80, -1}, {80, 40}, VoxelState::occupied));
	layers.update(cells({0, -1}, {79, -1}, VoxelState::occupied));
	Frontiers frontiers;
	frontiers.update(layers);
	ASSERT_EQ(frontiers.clusters().size(), 4U);
	double x_m = 0.5;
	for (const FrontierCluster& cluster : frontiers.clusters())
	{
		EXPECT_EQ(cluster.cells.size(), 20U);
		EXPECT_LT((cluster.outward - Eigen::Vector2d(0, 1)).norm(), 1e-9);
		EXPECT_LT((cluster.centroid_in_map - Eigen::Vector2d(x_m, 1.975)).norm(), 1e-9);
		x_m += 1.0;
	}
	// Half of it is closed by a wall.
	layers.update(cells({0, 40}, {39, 40}, VoxelState::occupied));
	frontiers.update(layers);
	ASSERT_EQ(frontiers.clusters().size(), 2U);
	EXPECT_GT(frontiers.clusters().front().centroid_in_map.x(), 2.0);
	// All of it.
	layers.update(cells({40, 40}, {79, 40}, VoxelState::occupied));
	frontiers.update(layers);
	EXPECT_TRUE(frontiers.clusters().empty());
}

TEST(Frontiers, AnIslandOfUnknownPointsNowhereInParticular)
{
	BodyLayers layers({}, {}, kResolution_m);
	for (const auto& [from, to] : std::vector<std::pair<Eigen::Vector2i, Eigen::Vector2i>>{
	         {{0, 0}, {8, 3}}, {{0, 5}, {8, 8}}, {{0, 4}, {3, 4}}, {{5, 4}, {8, 4}}})
		layers.update(cells(from, to, VoxelState::free));
	for (const auto& [from, to] : std::vector<std::pair<Eigen::Vector2i, Eigen::Vector2i>>{
	         {{-1, -1}, {9, -1}}, {{-1, 9}, {9, 9}}, {{-1, 0}, {-1, 8}}, {{9, 0}, {9, 8}}})
		layers.update(cells(from, to, VoxelState::occupied));
	Frontiers frontiers;
	frontiers.update(layers);
	ASSERT_EQ(frontiers.clusters().size(), 1U);
	EXPECT_EQ(frontiers.clusters().front().cells.size(), 4U);
	EXPECT_EQ(frontiers.clusters().front().outward.norm(), 0.0);
	EXPECT_LT((frontiers.clusters().front().centroid_in_map - Eigen::Vector2d(0.225, 0.225)).norm(), 1e-9);
}

TEST(Frontiers, SpaceAtTheEndOfTheRectangleBordersOnTheUnknown)
{
	BodyLayersConfig one_cell;
	one_cell.growth_m = kResolution_m;
	BodyLayers layers(one_cell, {}, kResolution_m);
	Frontiers frontiers;
	frontiers.update(layers);
	EXPECT_TRUE(frontiers.clusters().empty());
	layers.update(cells({0, 0}, {2, 2}, VoxelState::free));
	frontiers.update(layers);
	ASSERT_EQ(layers.frame().size(), 25U) << "a cell more on each side";
	ASSERT_EQ(frontiers.clusters().size(), 1U);
	EXPECT_EQ(frontiers.clusters().front().cells.size(), 8U);
	layers.update(cells({3, 0}, {5, 2}, VoxelState::free));
	frontiers.update(layers);
	EXPECT_EQ(frontiers.clusters().front().cells.size(), 14U);
	EXPECT_FALSE(frontiers.isFrontier(layers.frame().indexOf({3, 2, 0})));
}

TEST(FrontierConfig, EveryFieldIsInTheIni)
{
	FrontierConfig config{.max_length_m = 2.5}, loaded;
	const std::string ini = dumpIni([&](FieldVisitor& fields) { describe(fields, config); });
	loadIniText("test", ini, {}, [&](FieldVisitor& fields) { describe(fields, loaded); });
	EXPECT_EQ(loaded.max_length_m, 2.5);
}
}  // namespace
}  // namespace explore
