#include <explore/navigation/look_gain.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/drawn_map.h"
#include "support/random_points.h"

namespace explore
{
namespace
{
constexpr double kPi = std::numbers::pi;

/** 6 m × 4 m; known up to x = 3 m, nothing stands there. 0.2 m a character. */
std::vector<std::string> halfKnown()
{
	std::vector<std::string> rows(20, std::string(15, '.') + std::string(15, '?'));
	return rows;
}

PlanMap planOf(const test::DrawnMap& drawn, const Eigen::Vector3d& robot_in_map, const AllowedArea& area = {})
{
	return planMap({test::layersOf(drawn), area, robot_in_map, {}, {}}, {}, {});
}

/** Of unknown space that begins behind the line x = edge_m, seen from x = 0 along x: an integral over the rays. */
double gainBehindLine(double edge_m, const PlanConfig& config)
{
	constexpr int kRays = 20000;
	double area_m2 = 0.0;
	for (int i = 0; i < kRays; ++i)
	{
		const double azimuth_rad = ((i + 0.5) / kRays - 0.5) * config.view_angle_rad;
		const double from_m = edge_m / std::cos(azimuth_rad);
		const double to_m = std::min(from_m + config.view_depth_m, config.view_range_m);
		if (to_m > from_m) area_m2 += 0.5 * (to_m * to_m - from_m * from_m) * config.view_angle_rad / kRays;
	}
	return area_m2;
}

TEST(LookGain, IsTheAreaOfTheWedgeBehindTheEdge)
{
	const test::DrawnMap drawn(halfKnown(), 0.2);
	for (const double x_m : {0.525, 1.025, 1.525, 2.025})
		for (const double depth_m : {0.3, 0.6, 1.0})
		{
			PlanConfig config;
			config.view_depth_m = depth_m;
			const Eigen::Vector3d at(x_m, 2.025, 0.0);
			const PlanMap map = planOf(drawn, at);
			const double expected_m2 = gainBehindLine(3.0 - x_m, config);
			EXPECT_NEAR(lookGain(map, {map.cellOf(at), 0.0}, config), expected_m2, 0.12 * expected_m2 + 0.02)
			    << x_m << ", " << depth_m;
		}
}

TEST(LookGain, IsNothingWhereOneLooksElsewhere)
{
	const Eigen::Vector3d at(1.525, 2.025, 0.0);
	std::vector<std::string> rows = halfKnown();
	for (std::string& row : rows) row[0] = '#';
	const PlanMap map = planOf(test::DrawnMap(rows, 0.2), at);
	EXPECT_EQ(lookGain(map, {map.cellOf(at), kPi}, {}), 0.0) << "a wall";
	PlanConfig near_sighted;
	near_sighted.view_range_m = 1.4;
	EXPECT_EQ(lookGain(map, {map.cellOf(at), 0.0}, near_sighted), 0.0) << "the unknown is 1.475 m away";
}

TEST(LookGain, IsNothingBehindAWallHoweverThin)
{
	std::vector<std::string> rows(80, std::string(120, '.'));
	for (std::string& row : rows)
	{
		row.replace(60, 60, std::string(60, '?'));
		row[58] = '#';
	}
	// The wall has a gap at the far end, so that what is behind may be got to.
	for (std::size_t i = 0; i < 20; ++i) rows[i][58] = '.';
	const test::DrawnMap drawn(rows);
	const Eigen::Vector3d at(1.525, 1.275, 0.0);
	const PlanMap map = planOf(drawn, at);
	ASSERT_TRUE(map.wanted[map.cellOf({3.5, 1.3, 0.0})]);
	for (const double yaw_rad : {-0.2, 0.0, 0.2})
		EXPECT_EQ(lookGain(map, {map.cellOf(at), yaw_rad}, {}), 0.0) << yaw_rad;
}

TEST(LookGain, CountsOnlyWhatIsWanted)
{
	AllowedArea area;
	area.keep_out = {{{3.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {3.0, 4.0}}};
	const Eigen::Vector3d at(1.525, 2.025, 0.0);
	const PlanMap map = planOf(test::DrawnMap(halfKnown(), 0.2), at, area);
	EXPECT_EQ(lookGain(map, {map.cellOf(at), 0.0}, {}), 0.0);
	const PlanMap free = planOf(test::DrawnMap(halfKnown(), 0.2), at);
	EXPECT_GT(lookGain(free, {free.cellOf(at), 0.0}, {}), 0.5);
}

TEST(LookGain, GrowsWithTheViewButNotBeyondTheUnknown)
{
	const Eigen::Vector3d at(2.025, 2.025, 0.0);
	const PlanMap map = planOf(test::DrawnMap(halfKnown(), 0.2), at);
	double before_m2 = 0.0;
	for (const double range_m : {1.5, 2.0, 2.5})
	{
		PlanConfig config;
		config.view_range_m = range_m;
		const double gain_m2 = lookGain(map, {map.cellOf(at), 0.0}, config);
		EXPECT_GE(gain_m2, before_m2);
		before_m2 = gain_m2;
	}
}

/** How much of the line lies where nothing can be seen through [m]. */
double hidden(const test::DrawnMap& drawn, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
	int inside = 0;
	for (int i = 0; i < 1000; ++i) inside += drawn.on(from + (to - from) * (i / 1000.0)) != '.' ? 1 : 0;
	return inside / 1000.0 * (to - from).norm();
}

TEST(Sees, WhatIsInItsWedgeWithNothingBefore)
{
	std::mt19937 random(8);
	int seen = 0, unseen = 0;
	std::vector<std::string> rows(80, std::string(80, '.'));
	for (int i = 0; i < 30; ++i)
	{
		// Blocks of 15 cm and more, so that a ray that just grazes one does not decide.
		const std::size_t x = random() % 74, y = random() % 74;
		for (std::size_t row = y; row < y + 5; ++row) rows[row].replace(x, 5, i % 2 == 0 ? "#####" : "?????");
	}
	const test::DrawnMap drawn(rows);
	const PlanMap map = planOf(drawn, {2, 2, 0});
	const PlanConfig config;
	for (int trial = 0; trial < 4000; ++trial)
	{
		const auto anywhere = [&] {
			return map.cellOf({test::uniform(random, 0.1, 3.9), test::uniform(random, 0.1, 3.9), 0.0});
		};
		const CellIndex from = anywhere(), to = anywhere();
		if (from == to || map.cells[from] != CellState::free || map.cells[to] != CellState::free) continue;
		const Eigen::Vector2d a = map.middleOf(from).head<2>(), b = map.middleOf(to).head<2>();
		const double yaw_rad = test::uniform(random, -kPi, kPi);
		const double off_rad = std::abs(std::remainder(std::atan2(b.y() - a.y(), b.x() - a.x()) - yaw_rad, 2 * kPi));
		const bool in_wedge = off_rad < 0.5 * config.view_angle_rad && (b - a).norm() < config.view_range_m;
		const bool sees_it = sees(map, {from, yaw_rad}, map.middleOf(to), config);
		if (!in_wedge)
		{
			ASSERT_FALSE(sees_it);
			continue;
		}
		// What only grazes a block does not decide.
		const Eigen::Vector2d side = 0.04 * Eigen::Vector2d(a.y() - b.y(), b.x() - a.x()).normalized();
		const double hidden_m = hidden(drawn, a, b);
		const bool clear = hidden(drawn, a + side, b + side) + hidden(drawn, a - side, b - side) + hidden_m == 0.0;
		if (!clear && hidden_m < 0.15) continue;
		ASSERT_EQ(sees_it, clear) << a.transpose() << " to " << b.transpose();
		++(clear ? seen : unseen);
	}
	EXPECT_GT(seen, 40) << "the test saw too little";
	EXPECT_GT(unseen, 40) << "the test saw too little";
}

TEST(Sees, OtherAltitudesWithinTheImagesHeight)
{
	RobotConfig mav;
	mav.kind = RobotKind::mav;
	mav.height_m = 0.25;
	std::vector<std::string> rows(60, std::string(80, '.'));
	for (std::string& row : rows) row[60] = '#';
	const test::DrawnMap hall(rows);
	const BodyLayers layers = test::layersOf(hall, mav);
	const AllowedArea everywhere;
	const PlanMap map = planMap({layers, everywhere, {1.0, 1.5, 1.0}, {}, {}}, mav, {});
	const Look look{map.cellOf({0.5, 1.5, 1.0}), 0.0};
	EXPECT_TRUE(sees(map, look, map.middleOf(map.cellOf({2.5, 1.5, 1.75})), {})) << "21 degrees above";
	EXPECT_TRUE(sees(map, look, map.middleOf(map.cellOf({2.5, 1.5, 0.5})), {})) << "14 degrees below";
	EXPECT_FALSE(sees(map, look, map.middleOf(map.cellOf({1.5, 1.5, 1.75})), {})) << "37 degrees above";
	EXPECT_FALSE(sees(map, look, map.middleOf(map.cellOf({3.5, 1.5, 1.5})), {})) << "behind the wall";
}
}  // namespace
}  // namespace explore
