#include <explore/config/ini.h>
#include <explore/core/geometry.h>
#include <explore/memory/view_gain.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "layer_reference.h"
#include "support/random_points.h"

namespace explore
{
namespace
{
constexpr double kResolution_m = 0.05, kPi = std::numbers::pi;

/** Layers whose cells from −6 m to 6 m along x and y are as the function says. */
BodyLayers layersWhere(const std::function<VoxelState(const Eigen::Vector2d& at)>& state,
                       RobotKind kind = RobotKind::ground, double z_m = 0.3)
{
	BodyLayers layers({}, test::robotOf(kind), kResolution_m);
	const octomap::OcTree map(kResolution_m);
	std::vector<VoxelChange> changes;
	for (double y = -5.975; y < 6; y += kResolution_m)
		for (double x = -5.975; x < 6; x += kResolution_m)
			changes.push_back({map.coordToKey(x, y, z_m), VoxelState::unknown, state({x, y})});
	layers.update(changes);
	return layers;
}

/** Free up to 3 m from the map's origin. */
VoxelState disc(const Eigen::Vector2d& at)
{
	return at.norm() < 3.0 ? VoxelState::free : VoxelState::unknown;
}

double wrapped(double angle_rad)
{
	return std::abs(std::remainder(angle_rad, 2 * kPi));
}

/** Whether the sight from the camera to the cell's centre is as viewGain() wants it, step by small step. */
bool inSight(const BodyLayers& layers, const ViewPlace& place, const Eigen::Vector2d& centre, double max_unknown_m)
{
	constexpr double kStep_m = 0.004;
	const Eigen::Vector2d way = centre - place.camera_in_map;
	double unknown_m = 0.0;
	for (double done_m = 0.0; done_m < way.norm(); done_m += kStep_m)
	{
		const Eigen::Vector2d at = place.camera_in_map + done_m * way.normalized();
		const CellState state = layers.stateOf(layers.frame().cellAt(at, place.layer));
		if (state == CellState::occupied) return false;
		if (state == CellState::unknown) unknown_m += kStep_m;
	}
	return unknown_m <= max_unknown_m;
}

/** Cell by cell. */
double gainReference(const BodyLayers& layers, const ViewPlace& place, double yaw_rad, const ViewConfig& config)
{
	double sum_m2 = 0.0;
	const auto reach = static_cast<int>(config.range_m / kResolution_m) + 2;
	const LayerCell from = layers.frame().cellAt(place.camera_in_map, place.layer);
	for (int row = from.row - reach; row <= from.row + reach; ++row)
		for (int column = from.column - reach; column <= from.column + reach; ++column)
		{
			const Eigen::Vector2d centre =
			    layers.frame().corner_in_map + kResolution_m * Eigen::Vector2d(column + 0.5, row + 0.5);
			const Eigen::Vector2d way = centre - place.camera_in_map;
			if (way.norm() < config.min_range_m || way.norm() > config.range_m) continue;
			if (wrapped(std::atan2(way.y(), way.x()) - yaw_rad) > 0.5 * config.fov_rad) continue;
			if (layers.stateOf({column, row, place.layer}) != CellState::unknown) continue;
			if (inSight(layers, place, centre, config.max_unknown_m)) sum_m2 += kResolution_m * kResolution_m;
		}
	return sum_m2;
}

/** Free space in an irregular shape, unknown beyond it and in patches, walls and posts in it. */
BodyLayers randomPlan(std::mt19937& random)
{
	struct Disc
	{
		Eigen::Vector2d centre;
		double radius_m;
	};
	const auto discs = [&](int count, double reach_m, double least_m, double most_m)
	{
		std::vector<Disc> all;
		for (int i = 0; i < count; ++i)
			all.push_back({{test::uniform(random, -reach_m, reach_m), test::uniform(random, -reach_m, reach_m)},
			               test::uniform(random, least_m, most_m)});
		return all;
	};
	const std::vector<Disc> open = discs(6, 3, 1, 2), hidden = discs(4, 4, 0.1, 0.5), posts = discs(5, 4, 0.1, 0.4);
	const double wall_x_m = test::uniform(random, 1.5, 4), tilt = test::uniform(random, -0.8, 0.8);
	return layersWhere(
	    [&](const Eigen::Vector2d& at)
	    {
		    const auto in = [&](const Disc& disc) { return (at - disc.centre).norm() < disc.radius_m; };
		    if (std::abs(at.x() - wall_x_m + tilt * at.y()) < 0.1 && std::abs(at.y()) > 0.5)
			    return VoxelState::occupied;
		    if (std::ranges::any_of(posts, in)) return VoxelState::occupied;
		    if (std::ranges::any_of(hidden, in)) return VoxelState::unknown;
		    return std::ranges::any_of(open, in) ? VoxelState::free : VoxelState::unknown;
	    });
}

TEST(ViewGain, IsWhatACellByCellTestFinds)
{
	std::mt19937 random(3);
	double sum_m2 = 0, sum_reference_m2 = 0;
	for (int i = 0; i < 12; ++i)
	{
		const BodyLayers layers = randomPlan(random);
		for (int j = 0; j < 6; ++j)
		{
			ViewConfig config;
			config.max_unknown_m = j % 2 == 0 ? 1.0 : 0.4;
			config.fov_rad = j % 3 == 0 ? 2.0 : 1.0;
			const ViewPlace place{{test::uniform(random, -2, 2), test::uniform(random, -2, 2)}, 0};
			const double yaw_rad = test::uniform(random, -kPi, kPi);
			const double found_m2 = viewGain(layers, place, yaw_rad, config);
			const double reference_m2 = gainReference(layers, place, yaw_rad, config);
			EXPECT_NEAR(found_m2, reference_m2, 0.05 + 0.08 * reference_m2);
			sum_m2 += found_m2;
			sum_reference_m2 += reference_m2;
		}
	}
	EXPECT_GT(sum_reference_m2, 50.0);
	EXPECT_NEAR(sum_m2, sum_reference_m2, 0.02 * sum_reference_m2);
}

TEST(ViewGain, OfAllYawsIsThatOfEach)
{
	std::mt19937 random(4);
	for (const double fov_rad : {0.3, 57 * kPi / 180, 3.5, 2 * kPi})
	{
		const BodyLayers layers = randomPlan(random);
		const ViewConfig config{.fov_rad = fov_rad};
		const ViewPlace place{{0.31, -0.17}, 0};
		const std::array<double, kYaws> gains_m2 = viewGains(layers, place, config);
		BestYaw best{0.0, -1.0};
		for (int i = 0; i < kYaws; ++i)
		{
			const double gain_m2 = viewGain(layers, place, yawOf(i), config);
			EXPECT_NEAR(gains_m2[static_cast<std::size_t>(i)], gain_m2, 1e-9);
			if (gain_m2 > best.gain_m2 + 1e-9) best = {yawOf(i), gain_m2};
		}
		EXPECT_NEAR(bestYaw(layers, place, config).gain_m2, best.gain_m2, 1e-9);
		EXPECT_GT(best.gain_m2, 0.1);
	}
}

TEST(ViewGain, IsTheSectorOfARing)
{
	const BodyLayers layers = layersWhere(disc);
	// Unknown from 3 m on, of which 1 m counts.
	const double ring_m2 = 0.5 * (57 * kPi / 180) * (16 - 9);
	for (const double yaw_rad : {0.0, 0.4, -2.9, 3.1, 9.0})
		EXPECT_NEAR(viewGain(layers, {{0, 0}, 0}, yaw_rad, {}), ring_m2, 0.05 * ring_m2);
	EXPECT_NEAR(viewGain(layers, {{0, 0}, 0}, 0, {.range_m = 3.5}), 0.5 * (57 * kPi / 180) * (12.25 - 9), 0.15);
	EXPECT_EQ(viewGain(layers, {{0, 0}, 0}, 0, {.range_m = 2.5}), 0.0);
	EXPECT_NEAR(viewGain(layers, {{0, 0}, 0}, 0, {.fov_rad = 2 * kPi}), kPi * 7, 0.05 * kPi * 7);
}

TEST(ViewGain, LeavesOutWhatIsTooNear)
{
	const BodyLayers layers =
	    layersWhere([](const Eigen::Vector2d& at) { return at.norm() < 0.5 ? VoxelState::unknown : VoxelState::free; });
	EXPECT_EQ(viewGain(layers, {{0, 0}, 0}, 0, {}), 0.0);
	EXPECT_GT(viewGain(layers, {{0, 0}, 0}, 0, {.min_range_m = 0.2}), 0.05);
	EXPECT_GT(viewGain(layers, {{-1, 0}, 0}, 0, {}), 0.3);
}

TEST(ViewGain, NothingIsSeenThroughAWallAndOneLooksWhereThereIsNone)
{
	const BodyLayers layers = layersWhere(
	    [](const Eigen::Vector2d& at)
	    {
		    if (at.norm() > 2.0 && at.norm() < 2.2 && wrapped(std::atan2(at.y(), at.x()) - 2.0) > 0.6)
			    return VoxelState::occupied;
		    return disc(at);
	    });
	EXPECT_EQ(viewGain(layers, {{0, 0}, 0}, -1.0, {}), 0.0);
	const BestYaw best = bestYaw(layers, {{0, 0}, 0}, {});
	EXPECT_LT(wrapped(best.yaw_rad - 2.0), 0.2);
	EXPECT_NEAR(best.gain_m2, 0.5 * (57 * kPi / 180) * 7, 0.2);
}

TEST(ViewGain, ADropIsLookedAcrossAndIsNotUnknown)
{
	BodyLayers layers = layersWhere(disc);
	const double gain_m2 = viewGain(layers, {{0, 0}, 0}, 0, {});
	const octomap::OcTree map(kResolution_m);
	std::vector<VoxelChange> hole;
	for (double y = -0.975; y < 1; y += kResolution_m)
		for (double x = 1.025; x < 2; x += kResolution_m)
			hole.push_back({map.coordToKey(x, y, -0.3), VoxelState::unknown, VoxelState::free});
	layers.update(hole);
	ASSERT_EQ(layers.stateOf(layers.frame().cellAt({1.5, 0}, 0)), CellState::drop);
	EXPECT_EQ(viewGain(layers, {{0, 0}, 0}, 0, {}), gain_m2);
}

TEST(ViewGain, IsThatOfItsLayerAndReachesBeyondTheFrame)
{
	const BodyLayers layers = layersWhere(disc, RobotKind::mav, 1.0);
	const ViewPlace known{{0, 0}, 2}, unknown{{0, 0}, 6};
	EXPECT_NEAR(viewGain(layers, known, 0, {}), 0.5 * (57 * kPi / 180) * 7, 0.2);
	EXPECT_NEAR(viewGain(layers, unknown, 0, {}), 0.5 * (57 * kPi / 180) * (1 - 0.36), 0.02);
	EXPECT_NEAR(viewGain(layers, {{500, 0}, 2}, 0, {}), viewGain(layers, {{900, 0}, 2}, 0, {}), 1e-9);
	EXPECT_GT(viewGain(layers, {{500, 0}, 2}, 0, {}), 0.2);
}

TEST(ViewConfig, EveryFieldIsInTheIni)
{
	ViewConfig config{.fov_rad = 1.5, .min_range_m = 0.4, .range_m = 3.5, .max_unknown_m = 0.5}, loaded;
	const std::string ini = dumpIni([&](FieldVisitor& fields) { describe(fields, config); });
	loadIniText("test", ini, {}, [&](FieldVisitor& fields) { describe(fields, loaded); });
	EXPECT_NEAR(loaded.fov_rad, 1.5, 1e-9);
	EXPECT_EQ(loaded.min_range_m, 0.4);
	EXPECT_EQ(loaded.range_m, 3.5);
	EXPECT_EQ(loaded.max_unknown_m, 0.5);
}
}  // namespace
}  // namespace explore
