#include <explore/config/ini.h>
#include <explore/core/errors.h>
#include <explore/memory/body_layers.h>
#include <gtest/gtest.h>

#include <set>

#include "layer_reference.h"
#include "map_scenes.h"
#include "random_voxels.h"

namespace explore
{
namespace
{
constexpr double kResolution_m = 0.05;

/** Small steps, so that the rectangle grows often. */
BodyLayersConfig smallSteps()
{
	BodyLayersConfig config;
	config.growth_m = 0.5;
	return config;
}

VoxelChange change(const Eigen::Vector3d& at, VoxelState before, VoxelState after)
{
	const octomap::OcTree map(kResolution_m);
	return {map.coordToKey(at.x(), at.y(), at.z()), before, after};
}

VoxelChange found(const Eigen::Vector3d& at, VoxelState state)
{
	return change(at, VoxelState::unknown, state);
}

CellState stateAt(const BodyLayers& layers, const Eigen::Vector2d& at, int layer = 0)
{
	return layers.stateOf(layers.frame().cellAt(at, layer));
}

/** The old states, moved into the frame of now. */
std::vector<CellState> moved(const std::vector<CellState>& cells, const LayerFrame& old, const LayerFrame& now)
{
	std::vector<CellState> all(now.size(), CellState::unknown);
	for (std::size_t i = 0; i < cells.size(); ++i)
	{
		const Eigen::Vector2d centre = old.centreOf(i);
		all[now.indexAt(centre, old.cellOf(i).layer).value()] = cells[i];
	}
	return all;
}

TEST(BodyLayers, TheVoxelOfTheFloorIsInNobodysWay)
{
	for (const double resolution_m : {0.02, 0.05, 0.07, 0.1})
		for (const double floor_z_m : {0.0, 0.13, -2.0})
		{
			BodyLayersConfig config = smallSteps();
			config.floor_z_m = floor_z_m;
			BodyLayers layers(config, test::robotOf(RobotKind::ground), resolution_m);
			const octomap::OcTree map(resolution_m);
			const auto foundAt = [&](double x, double z, VoxelState state) -> VoxelChange {
				return {map.coordToKey(x, 0.01, z), VoxelState::unknown, state};
			};
			std::vector<VoxelChange> changes;
			for (const double x : {0.31, 0.93})
			{
				changes.push_back(foundAt(x, floor_z_m + 1e-4, VoxelState::occupied));
				for (double z_m = floor_z_m + 1.5 * resolution_m; z_m < floor_z_m + 0.6; z_m += resolution_m)
					changes.push_back(foundAt(x, z_m, VoxelState::free));
			}
			// A box that is higher than any of these voxels.
			changes.push_back({map.coordToKey(0.93, 0.01, floor_z_m + 0.25), VoxelState::free, VoxelState::occupied});
			layers.update(changes);
			EXPECT_EQ(stateAt(layers, {0.31, 0.01}), CellState::free) << resolution_m << " at " << floor_z_m;
			EXPECT_EQ(stateAt(layers, {0.93, 0.01}), CellState::occupied) << resolution_m << " at " << floor_z_m;
		}
}

class BodyLayersOf : public testing::TestWithParam<RobotKind>
{
};

TEST_P(BodyLayersOf, AreThoseOfTheWholeMapAfterEveryChange)
{
	for (std::uint32_t seed = 1; seed <= 6; ++seed)
	{
		test::RandomVoxels voxels(seed);
		BodyLayers layers(smallSteps(), test::robotOf(GetParam()), kResolution_m);
		for (int i = 0; i < 12; ++i)
		{
			voxels.change(i == 0 ? 40000 : 3000, {i % 3 * 7, i / 3 * -9, 0});
			layers.update(voxels.changes());
			ASSERT_EQ(layers.cells(), test::layersReference(voxels.map(), layers.frame(), GetParam()));
		}
		std::set<CellState> kinds(layers.cells().begin(), layers.cells().end());
		EXPECT_EQ(kinds.size(), GetParam() == RobotKind::ground ? 4U : 3U) << "the test saw too little";
	}
}

TEST_P(BodyLayersOf, SayWhichCellsChanged)
{
	test::RandomVoxels voxels(7);
	BodyLayers layers(smallSteps(), test::robotOf(GetParam()), kResolution_m);
	for (int i = 0; i < 10; ++i)
	{
		const LayerFrame frame_before = layers.frame();
		const std::vector<CellState> before = layers.cells();
		voxels.change(2000, {11 * i, 0, 0});
		if (i % 4 == 2) layers.stood({0.55 * i, 0.2, 1.1});
		if (i % 4 == 3)
			layers.rebuild(voxels.map());
		else
			layers.update(voxels.changes());
		const std::vector<CellState> old = moved(before, frame_before, layers.frame());
		std::set<std::size_t> expected;
		for (std::size_t cell = 0; cell < old.size(); ++cell)
			if (old[cell] != layers.cells()[cell]) expected.insert(cell);
		const std::set<std::size_t> told(layers.changedCells().begin(), layers.changedCells().end());
		EXPECT_EQ(told, expected);
		EXPECT_EQ(told.size(), layers.changedCells().size()) << "one came twice";
		EXPECT_FALSE(told.empty());
	}
	EXPECT_EQ(layers.revision(), 10U);
}

TEST_P(BodyLayersOf, AreTheSameWhenRebuiltFromTheMap)
{
	test::RandomVoxels voxels(8);
	BodyLayers grown(smallSteps(), test::robotOf(GetParam()), kResolution_m);
	for (int i = 0; i < 10; ++i)
	{
		voxels.change(8000, {5 * i, 3 * i, 0});
		grown.update(voxels.changes());
	}
	octomap::OcTree pruned = voxels.map();
	pruned.prune();
	BodyLayers rebuilt(smallSteps(), test::robotOf(GetParam()), kResolution_m);
	rebuilt.rebuild(pruned);
	EXPECT_EQ(moved(rebuilt.cells(), rebuilt.frame(), grown.frame()), grown.cells());
	// A corrected map takes the place of the old one.
	const octomap::OcTree empty(kResolution_m);
	grown.rebuild(empty);
	EXPECT_EQ(std::ranges::count(grown.cells(), CellState::unknown), std::ssize(grown.cells()));
}

INSTANTIATE_TEST_SUITE_P(Robots, BodyLayersOf, testing::Values(RobotKind::ground, RobotKind::mav),
                         [](const auto& tested) { return std::string(nameOf(tested.param)); });

TEST(BodyLayers, CoverTheFlightBandOfAMav)
{
	RobotConfig mav = test::robotOf(RobotKind::mav);
	EXPECT_EQ(BodyLayers({}, mav, kResolution_m).frame().altitudes_m,
	          (std::vector<double>{0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0}));
	mav.max_altitude_m = 1.1;
	EXPECT_EQ(BodyLayers({}, mav, kResolution_m).frame().altitudes_m, (std::vector<double>{0.5, 0.75, 1.0, 1.1}));
	mav.min_altitude_m = 1.1;
	EXPECT_EQ(BodyLayers({}, mav, kResolution_m).frame().altitudes_m, (std::vector<double>{1.1}));
	BodyLayersConfig upstairs;
	upstairs.floor_z_m = 3.0;
	EXPECT_EQ(BodyLayers(upstairs, mav, kResolution_m).frame().altitudes_m, (std::vector<double>{4.1}));
	EXPECT_EQ(BodyLayers({}, {}, kResolution_m).frame().layers(), 1);
}

TEST(BodyLayers, WhatIsUnderneathOrAboveIsNotInTheWay)
{
	BodyLayers ground({}, {}, kResolution_m);
	ground.update(std::vector{found({1.02, 0, 0.03}, VoxelState::occupied),
	                          found({1.02, 0, 0.62}, VoxelState::occupied), found({1.02, 0, 0.3}, VoxelState::free),
	                          found({1.52, 0, 0.12}, VoxelState::occupied),
	                          found({2.02, 0, 0.58}, VoxelState::occupied)});
	EXPECT_EQ(stateAt(ground, {1.02, 0.01}), CellState::free);
	EXPECT_EQ(stateAt(ground, {1.52, 0.01}), CellState::occupied);
	EXPECT_EQ(stateAt(ground, {2.02, 0.01}), CellState::occupied);
	EXPECT_EQ(stateAt(ground, {1.07, 0.01}), CellState::unknown);
	EXPECT_EQ(stateAt(ground, {900.0, 0.01}), CellState::unknown);
	// What leaves, leaves.
	ground.update(std::vector{change({1.52, 0, 0.12}, VoxelState::occupied, VoxelState::free),
	                          change({2.02, 0, 0.58}, VoxelState::occupied, VoxelState::unknown)});
	EXPECT_EQ(stateAt(ground, {1.52, 0.01}), CellState::free);
	EXPECT_EQ(stateAt(ground, {2.02, 0.01}), CellState::unknown);
}

TEST(BodyLayers, FollowTheFloorTheyAreToldOf)
{
	BodyLayersConfig upstairs;
	upstairs.floor_z_m = 3.0;
	BodyLayers layers(upstairs, {}, kResolution_m);
	layers.update(std::vector{found({1, 0, 0.3}, VoxelState::occupied), found({2, 0, 3.3}, VoxelState::occupied),
	                          found({4, 0, 2.7}, VoxelState::free)});
	EXPECT_EQ(stateAt(layers, {1.01, 0.01}), CellState::unknown);
	EXPECT_EQ(stateAt(layers, {2.01, 0.01}), CellState::occupied);
	EXPECT_EQ(stateAt(layers, {4.01, 0.01}), CellState::drop);
}

TEST(BodyLayers, GrowInEveryDirectionAndKeepWhatTheyKnow)
{
	BodyLayers layers({}, {}, kResolution_m);
	EXPECT_EQ(layers.frame().size(), 0U);
	layers.update({});
	EXPECT_EQ(layers.frame().size(), 0U);
	std::vector<Eigen::Vector2d> places;
	for (const Eigen::Vector2d& place :
	     {Eigen::Vector2d(0.01, 0.01), {30.01, 2.01}, {-29.99, 5.01}, {3.01, 41.01}, {2.01, -40.99}})
	{
		places.push_back(place);
		layers.update(std::vector{found({place.x(), place.y(), 0.3}, VoxelState::occupied)});
		const LayerFrame& frame = layers.frame();
		EXPECT_TRUE(frame.corner_in_map.isApprox(kResolution_m * frame.first.cast<double>()));
		EXPECT_EQ(frame.size(), layers.cells().size());
		for (const Eigen::Vector2d& known : places)
		{
			const std::size_t index = frame.indexAt(known, 0).value();
			EXPECT_EQ(layers.cells()[index], CellState::occupied);
			EXPECT_LE((frame.centreOf(index) - known).cwiseAbs().maxCoeff(), 0.5 * kResolution_m + 1e-9);
			EXPECT_EQ(frame.indexOf(frame.cellOf(index)), index);
		}
		EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(layers.cells(), CellState::occupied)), places.size());
	}
}

TEST(BodyLayers, RefuseAMapThatIsTooLongAndStayAsTheyWere)
{
	BodyLayers layers({}, {}, kResolution_m);
	layers.update(std::vector{found({0, 0, 0.3}, VoxelState::occupied)});
	const std::vector<CellState> before = layers.cells();
	const std::vector far{found({1, 0, 0.3}, VoxelState::occupied), found({410, 0, 0.3}, VoxelState::occupied)};
	EXPECT_THROW(layers.update(far), InputError);
	EXPECT_EQ(layers.cells(), before);
	EXPECT_EQ(layers.revision(), 1U);
	layers.update(std::vector{found({370, 0, 0.3}, VoxelState::occupied)});
	EXPECT_EQ(stateAt(layers, {370.01, 0.01}), CellState::occupied);
	// What no layer looks at takes no cells.
	layers.update(std::vector{found({1000, 0, 5.0}, VoxelState::occupied)});
}

TEST(BodyLayers, RefuseLayersThatTheyCannotCount)
{
	RobotConfig tall;
	tall.height_m = 6.0;
	EXPECT_THROW(BodyLayers({}, tall, 0.02), ConfigError);
}

TEST(BodyLayers, WhereTheBodyStoodIsFreeUnlessSomethingStandsThereNow)
{
	BodyLayers layers({}, {}, kResolution_m);
	layers.stood({2.0, 1.0, 0.0});
	EXPECT_EQ(layers.frame().size(), 0U) << "from the next update on";
	layers.update({});
	int free = 0;
	for (std::size_t i = 0; i < layers.cells().size(); ++i)
	{
		const double distance_m = (layers.frame().centreOf(i) - Eigen::Vector2d(2, 1)).norm();
		ASSERT_EQ(layers.cells()[i], distance_m <= 0.22 ? CellState::free : CellState::unknown);
		free += static_cast<int>(layers.cells()[i] == CellState::free);
	}
	EXPECT_NEAR(free * kResolution_m * kResolution_m, 0.152, 0.02);
	layers.update(
	    std::vector{found({2.02, 1.02, 0.3}, VoxelState::occupied), found({1.92, 1.02, -0.3}, VoxelState::free)});
	EXPECT_EQ(stateAt(layers, {2.02, 1.02}), CellState::occupied);
	EXPECT_EQ(stateAt(layers, {1.92, 1.02}), CellState::free) << "it carried the robot";
	layers.update(std::vector{change({2.02, 1.02, 0.3}, VoxelState::occupied, VoxelState::unknown)});
	EXPECT_EQ(stateAt(layers, {2.02, 1.02}), CellState::free);
	// A corrected map comes with corrected places.
	layers.stood({5.0, 1.0, 0.0});
	layers.rebuild(octomap::OcTree(kResolution_m));
	EXPECT_EQ(stateAt(layers, {2.02, 1.02}), CellState::unknown);
	EXPECT_EQ(stateAt(layers, {5.02, 1.02}), CellState::free);
}

TEST(BodyLayers, AMavFreesTheLayerItFliesIn)
{
	BodyLayers layers({}, test::robotOf(RobotKind::mav), kResolution_m);
	layers.stood({2.0, 1.0, 1.3});
	layers.stood({4.0, 1.0, 0.1});  // not yet in its flight band
	layers.update({});
	for (int layer = 0; layer < layers.frame().layers(); ++layer)
	{
		EXPECT_EQ(stateAt(layers, {2.01, 1.01}, layer), layer == 3 ? CellState::free : CellState::unknown);
		EXPECT_EQ(stateAt(layers, {4.01, 1.01}, layer), CellState::unknown);
	}
}

/** The map of a scene, seen from several places, goes into layers. */
BodyLayers layersOf(const test::Scene& scene, const std::vector<mrpt::poses::CPose3D>& views, RobotKind kind)
{
	Occupancy map({});
	BodyLayers layers({}, test::robotOf(kind), kResolution_m);
	for (const mrpt::poses::CPose3D& view : views)
		for (std::uint32_t i = 0; i < 5; ++i)
		{
			map.insert(test::viewOf(scene, view, {.axial_scale = 1.0, .seed = i}, 320));
			layers.update(map.changes());
		}
	return layers;
}

TEST(BodyLayers, AStairwellIsADropAndTheFloorIsNot)
{
	test::Scene scene;
	scene.floor(-1, -2, 2.5, 2).floor(2.5, 0.8, 4.5, 2).floor(2.5, -2, 4.5, -0.8).floor(4.5, -2, 6, 2);
	scene.floor(2.5, -0.8, 4.5, 0.8, -1.0).patch({{4.5, -0.8, -1}, {0, 1.6, 0}, {0, 0, 1}});
	for (const double side : {-0.8, 0.8}) scene.patch({{2.5, side, -1}, {2, 0, 0}, {0, 0, 1}});
	scene.wall({6, -3}, {6, 3}, 2.5).wall({-1, -2}, {6, -2}, 2.5).wall({-1, 2}, {6, 2}, 2.5);
	const BodyLayers layers = layersOf(scene, {{0, 0, 0.5, 0, 0.2, 0}, {1, 0, 0.5, 0, 0.3, 0}}, RobotKind::ground);
	int drops = 0;
	for (std::size_t i = 0; i < layers.cells().size(); ++i)
	{
		if (layers.cells()[i] != CellState::drop) continue;
		const Eigen::Vector2d at = layers.frame().centreOf(i);
		++drops;
		EXPECT_TRUE(at.x() > 2.4 && at.x() < 4.6 && std::abs(at.y()) < 0.9) << at.transpose();
	}
	EXPECT_GT(drops * kResolution_m * kResolution_m, 1.5) << "of 3.2 m² of hole";
	EXPECT_EQ(stateAt(layers, {2.81, 0.01}), CellState::drop);
	EXPECT_EQ(stateAt(layers, {2.01, 0.01}), CellState::free);
	EXPECT_EQ(stateAt(layers, {5.01, 0.01}), CellState::free);
	EXPECT_EQ(stateAt(layers, {3.51, 1.21}), CellState::free);
}

TEST(BodyLayers, AThinPoleIsInTheWay)
{
	test::Scene scene;
	scene.floor(-1, -3, 5, 3).wall({4.5, -3}, {4.5, 3}, 2.5).box({2.52, 0.02, 1.0}, {0.02, 0.02, 2.0});
	const BodyLayers ground = layersOf(scene, {{0, 0.1, 0.5, 0, 0, 0}, {0.3, -0.2, 0.5, 0, 0, 0}}, RobotKind::ground);
	EXPECT_EQ(stateAt(ground, {2.51, 0.01}), CellState::occupied);
	EXPECT_EQ(stateAt(ground, {2.51, 0.31}), CellState::free);
	const BodyLayers mav = layersOf(scene, {{0, 0.1, 1.0, 0, 0, 0}, {0.3, -0.2, 1.0, 0, 0, 0}}, RobotKind::mav);
	for (int layer = 0; layer < 5; ++layer) EXPECT_EQ(stateAt(mav, {2.51, 0.01}, layer), CellState::occupied) << layer;
}

TEST(BodyLayersConfig, EveryFieldIsInTheIni)
{
	BodyLayersConfig config{.floor_z_m = 1.5,
	                        .lowest_m = 0.05,
	                        .layer_step_m = 0.3,
	                        .body_margin_m = 0.1,
	                        .drop_m = 0.2,
	                        .drop_reach_m = 0.6,
	                        .floor_tolerance_m = 0.08,
	                        .growth_m = 10,
	                        .max_edge_m = 100};
	const std::string ini = dumpIni([&](FieldVisitor& fields) { describe(fields, config); });
	BodyLayersConfig loaded;
	loadIniText("test", ini, {}, [&](FieldVisitor& fields) { describe(fields, loaded); });
	EXPECT_EQ(dumpIni([&](FieldVisitor& fields) { describe(fields, loaded); }), ini);
	EXPECT_EQ(loaded.drop_reach_m, 0.6);
	EXPECT_EQ(loaded.max_edge_m, 100);
}
}  // namespace
}  // namespace explore
