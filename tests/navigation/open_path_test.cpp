#include <explore/navigation/open_path.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "obstacle_scenes.h"

namespace explore
{
namespace
{
using test::addWall;
using test::evenClearance;
using test::floorBelow;
using test::onFloor;
using test::randomCloud;
using test::wallCloud;

constexpr double kPi = std::numbers::pi;

RobotConfig mav()
{
	RobotConfig robot;
	robot.kind = RobotKind::mav;
	robot.radius_m = 0.30;
	robot.height_m = 0.25;
	return robot;
}

/** d(θ) point by point, as method.md writes it. */
double bruteForce(const PointCloud& cloud, double azimuth, double radius, double range)
{
	double open = range;
	const Eigen::Vector2d along(std::cos(azimuth), std::sin(azimuth));
	for (std::size_t i = 0; i < cloud.size(); ++i)
	{
		const Eigen::Vector2d point = cloud[i].cast<double>().head<2>();
		const double ahead = point.dot(along), aside2 = (point - ahead * along).squaredNorm();
		if (ahead > 0.0 && aside2 < radius * radius)
			open = std::min(open, std::max(0.0, ahead - std::sqrt(radius * radius - aside2)));
	}
	return open;
}

/** The first of small steps along the direction at which a point that was outside is inside the cylinder. */
double marched(const PointCloud& cloud, const Direction& direction, double radius, double half_height, double range,
               double step)
{
	const Eigen::Vector3d along(std::cos(direction.elevation_rad) * std::cos(direction.azimuth_rad),
	                            std::cos(direction.elevation_rad) * std::sin(direction.azimuth_rad),
	                            std::sin(direction.elevation_rad));
	for (double travel = 0.0; travel < range; travel += step)
		for (std::size_t i = 0; i < cloud.size(); ++i)
		{
			const Eigen::Vector3d offset = cloud[i].cast<double>() - travel * along;
			if (offset.head<2>().norm() < radius && std::abs(offset.z()) < half_height) return travel;
		}
	return range;
}

TEST(OpenPath, FanEqualsBruteForceOverRandomPoints)
{
	std::mt19937 random(7);
	std::uniform_real_distribution<double> angle(-kPi, kPi), radius(0.05, 0.6);
	AvoiderConfig config = evenClearance();
	config.step_height_m = 0.0;
	for (int trial = 0; trial < 60; ++trial)
	{
		const PointCloud cloud = randomCloud(random, 1 + trial * 4, 1.0 + 0.08 * trial);
		RobotConfig robot;
		robot.radius_m = radius(random);
		robot.height_m = 20.0;
		AvoiderInput input = onFloor(cloud);
		input.ground = floorBelow(10.0);
		const OpenPath open_path(input, robot, config);
		const DirectionFan fan{angle(random), 2.0 * kPi / 181, 181};
		const std::vector<double> open = open_path.along(fan);
		ASSERT_EQ(open.size(), 181U);
		for (std::size_t k = 0; k < fan.count; ++k)
			ASSERT_NEAR(
			    open[k],
			    bruteForce(cloud, fan.at(k).azimuth_rad, robot.radius_m + config.clearance_m, config.max_range_m), 1e-6)
			    << "trial " << trial << ", direction " << k;
	}
}

TEST(OpenPath, SingleDirectionsAndAnyFanAgree)
{
	std::mt19937 random(8);
	std::uniform_real_distribution<double> angle(-3.0 * kPi, 3.0 * kPi), step(0.01, 0.3);
	const PointCloud cloud = randomCloud(random, 200, 4.0);
	AvoiderInput input = onFloor(cloud);
	input.ground = floorBelow(5.0);
	RobotConfig robot;
	robot.height_m = 10.0;
	const OpenPath open_path(input, robot, evenClearance());
	for (int trial = 0; trial < 100; ++trial)
	{
		DirectionFan fan{angle(random), step(random), 0};
		fan.count = 1 + static_cast<std::size_t>(trial % 20);
		const std::vector<double> open = open_path.along(fan);
		for (std::size_t k = 0; k < fan.count; ++k) ASSERT_NEAR(open[k], open_path.along(fan.at(k)), 1e-12);
	}
}

TEST(OpenPath, FlightEqualsMarchingTheCylinderThroughTheCloud)
{
	std::mt19937 random(9);
	std::uniform_real_distribution<double> azimuth(-kPi, kPi), elevation(-0.6, 0.6);
	RobotConfig robot = mav();
	robot.min_altitude_m = 0.0;
	robot.max_altitude_m = 100.0;
	const AvoiderConfig config = evenClearance();
	const double radius = robot.radius_m + config.clearance_m, half_height = 0.5 * robot.height_m + config.clearance_m;
	constexpr double kStep_m = 0.0005;
	int hits = 0;
	for (int trial = 0; trial < 150; ++trial)
	{
		PointCloud cloud = randomCloud(random, 40, 2.0);
		// A point inside the hull from the start is another test's matter.
		for (std::size_t i = 0; i < cloud.size(); ++i)
			if (cloud[i].head<2>().norm() < radius + 0.01 && std::abs(cloud[i].z()) < half_height + 0.01)
				cloud.x[i] += 1;
		AvoiderInput input = onFloor(cloud);
		input.ground = floorBelow(50.0);
		const Direction direction{azimuth(random), trial % 3 == 0 ? 0.0 : elevation(random)};
		const double open = OpenPath(input, robot, config).along(direction);
		const double truth = marched(cloud, direction, radius, half_height, config.max_range_m, kStep_m);
		// A march may step over a grazed corner; it never stops early.
		ASSERT_LE(open, truth + 1e-6) << "trial " << trial;
		if (truth < config.max_range_m) ++hits;
		if (truth - open > 2.0 * kStep_m)
		{
			const Eigen::Vector3d along(std::cos(direction.elevation_rad) * std::cos(direction.azimuth_rad),
			                            std::cos(direction.elevation_rad) * std::sin(direction.azimuth_rad),
			                            std::sin(direction.elevation_rad));
			double deepest = 1.0;
			for (std::size_t i = 0; i < cloud.size(); ++i)
			{
				const Eigen::Vector3d offset = cloud[i].cast<double>() - (open + 0.5 * kStep_m) * along;
				deepest =
				    std::min(deepest, std::max(offset.head<2>().norm() - radius, std::abs(offset.z()) - half_height));
			}
			EXPECT_NEAR(deepest, 0.0, kStep_m) << "trial " << trial << ": nothing is touched where the path ends";
		}
	}
	EXPECT_GT(hits, 40);
}

TEST(OpenPath, WallAheadIsItsDistanceMinusTheHull)
{
	const PointCloud cloud = wallCloud({2.0, -3.0}, {2.0, 3.0});
	const OpenPath open_path(onFloor(cloud), RobotConfig(), evenClearance());
	EXPECT_NEAR(open_path.along(Direction{0.0}), 2.0 - 0.27, 1e-3);
	EXPECT_NEAR(open_path.along(Direction{0.5}), (2.0 - 0.27) / std::cos(0.5), 2e-3);
	EXPECT_DOUBLE_EQ(open_path.along(Direction{kPi}), 5.0);
}

TEST(OpenPath, PointBesideTheCorridorDoesNotCap)
{
	PointCloud cloud;
	cloud.push_back({1.0F, 0.28F, 0.3F});  // the paper's projection would cap d(0) at 1 m
	const OpenPath open_path(onFloor(cloud), RobotConfig(), evenClearance());
	EXPECT_DOUBLE_EQ(open_path.along(Direction{0.0}), 5.0);
	EXPECT_LT(open_path.along(Direction{0.1}), 1.0);
}

TEST(OpenPath, DoorwayThatJustFitsAndOneThatJustDoesNot)
{
	for (const double half_width : {0.275, 0.265})
	{
		PointCloud cloud;
		addWall(cloud, {1.5, half_width}, {1.5, 3.0});
		addWall(cloud, {1.5, -half_width}, {1.5, -3.0});
		const double open = OpenPath(onFloor(cloud), RobotConfig(), evenClearance()).along(Direction{0.0});
		if (half_width > 0.27)
			EXPECT_DOUBLE_EQ(open, 5.0);
		else
			EXPECT_NEAR(open, 1.5 - std::sqrt(0.27 * 0.27 - 0.265 * 0.265), 1e-3);
	}
}

TEST(OpenPath, ClearanceFadesToAFifthWithDistance)
{
	AvoiderConfig config;
	config.clearance_m = 0.10;
	config.clearance_range_m = 1.0;
	// Distance from the robot's centre, then the half width of a gap that is just too narrow and one that is just not.
	for (const auto& [ahead, half_width] :
	     std::vector<std::pair<double, double>>{{0.45, 0.296}, {0.72, 0.27}, {3.0, 0.24}})
		for (const double off : {-0.003, 0.003})
		{
			const double lateral = half_width + off;
			PointCloud cloud;
			const double x = std::sqrt(ahead * ahead - lateral * lateral);
			for (const double side : {1.0, -1.0})
				cloud.push_back({static_cast<float>(x), static_cast<float>(side * lateral), 0.3F});
			const double open = OpenPath(onFloor(cloud), RobotConfig(), config).along(Direction{0.0});
			EXPECT_EQ(open == 5.0, off > 0.0) << "gap " << 2.0 * lateral << " m wide at " << ahead << " m: " << open;
		}
}

TEST(OpenPath, PointInsideTheHullBlocksOnlyTheWayTowardIt)
{
	PointCloud cloud;
	cloud.push_back({0.0F, 0.1F, 0.3F});
	const OpenPath open_path(onFloor(cloud), RobotConfig(), evenClearance());
	EXPECT_EQ(open_path.along(Direction{0.5 * kPi}), 0.0);
	EXPECT_EQ(open_path.along(Direction{0.1}), 0.0);
	EXPECT_DOUBLE_EQ(open_path.along(Direction{-0.1}), 5.0);
	EXPECT_DOUBLE_EQ(open_path.along(Direction{-0.5 * kPi}), 5.0);
}

TEST(OpenPath, GroundRobotIgnoresWhatItRollsOverAndWhatHangsAboveIt)
{
	const std::vector<std::pair<float, bool>> blocked_at{{0.02F, false}, {0.049F, false}, {0.06F, true}, {0.3F, true},
	                                                     {0.64F, true},  {0.66F, false},  {2.5F, false}};
	for (const auto& [height, blocks] : blocked_at)
	{
		PointCloud cloud;
		cloud.push_back({1.0F, 0.0F, height});
		const double open = OpenPath(onFloor(cloud), RobotConfig(), evenClearance()).along(Direction{0.0});
		EXPECT_NEAR(open, blocks ? 0.73 : 5.0, 1e-6) << "height " << height;
	}
}

TEST(OpenPath, DropBlocksWhereTheFloorEnds)
{
	// Camera 0.5 m up; the ray to a point 3 m ahead and 1 m below the floor pierces the floor at 1 m.
	PointCloud cloud;
	cloud.push_back({3.0F, 0.0F, -1.0F});
	AvoiderInput input = onFloor(cloud);
	EXPECT_NEAR(OpenPath(input, RobotConfig(), evenClearance()).along(Direction{0.0}), 3.0 - 0.27, 1e-6);
	input.sensor_in_robot = Eigen::Vector3d(0.0, 0.0, 0.5);
	EXPECT_NEAR(OpenPath(input, RobotConfig(), evenClearance()).along(Direction{0.0}), 1.0 - 0.27, 1e-6);
}

TEST(OpenPath, NothingIsLowWhereNoFloorWasSeen)
{
	PointCloud cloud;
	cloud.push_back({1.0F, 0.0F, -0.45F});
	AvoiderInput input = onFloor(cloud);
	input.ground.reset();
	EXPECT_NEAR(OpenPath(input, RobotConfig(), evenClearance()).along(Direction{0.0}), 0.73, 1e-6);
	cloud.z[0] = 0.7F;
	EXPECT_DOUBLE_EQ(OpenPath(input, RobotConfig(), evenClearance()).along(Direction{0.0}), 5.0);
}

TEST(OpenPath, TiltedFrameMeasuresAlongTheFloor)
{
	// A camera 0.5 m up that looks 0.25 rad down and is itself the robot frame; a pole 2 m ahead, 0.4 m left.
	const double pitch = 0.25;
	const Eigen::AngleAxisd level_from_robot(pitch, Eigen::Vector3d::UnitY());
	const Eigen::Matrix3d robot_from_level = level_from_robot.toRotationMatrix().transpose();
	PointCloud cloud;
	for (double z = -0.4; z < 0.1; z += 0.05)
		cloud.push_back((robot_from_level * Eigen::Vector3d(2.0, 0.4, z)).cast<float>());
	AvoiderInput input = onFloor(cloud);
	input.ground = Plane{robot_from_level * Eigen::Vector3d::UnitZ(), 0.5};
	const OpenPath open_path(input, RobotConfig(), evenClearance());
	EXPECT_NEAR(open_path.along(Direction{std::atan2(0.4, 2.0)}), std::hypot(2.0, 0.4) - 0.27, 1e-5);
	EXPECT_DOUBLE_EQ(open_path.along(Direction{0.0}), 5.0);
}

TEST(OpenPath, FlightBandEndsClimbAndDescent)
{
	const PointCloud cloud;
	AvoiderInput input = onFloor(cloud);
	input.ground = floorBelow(1.4);  // the body's centre flies 1.4 m above the floor
	const OpenPath open_path(input, mav(), evenClearance());
	EXPECT_NEAR(open_path.along(Direction{0.0, kPi / 6}), 0.6 / 0.5, 1e-9);
	EXPECT_NEAR(open_path.along(Direction{0.0, -kPi / 6}), 0.9 / 0.5, 1e-9);
	EXPECT_DOUBLE_EQ(open_path.along(Direction{0.0, 0.0}), 5.0);
	input.ground = floorBelow(2.3);
	EXPECT_EQ(OpenPath(input, mav(), evenClearance()).along(Direction{0.0, 0.1}), 0.0);
	input.ground.reset();
	EXPECT_EQ(OpenPath(input, mav(), evenClearance()).along(Direction{0.0, -0.1}), 0.0);
}

TEST(OpenPath, MavPassesOverAndUnderWhatItsBodyClears)
{
	PointCloud cloud;
	cloud.push_back({1.0F, 0.0F, 0.18F});
	AvoiderInput input = onFloor(cloud);
	input.ground = floorBelow(1.0);
	const OpenPath open_path(input, mav(), evenClearance());
	EXPECT_DOUBLE_EQ(open_path.along(Direction{0.0, 0.0}), 5.0);  // half height 0.125 + clearance 0.05
	cloud.z[0] = 0.17F;
	EXPECT_NEAR(OpenPath(input, mav(), evenClearance()).along(Direction{0.0, 0.0}), 0.65, 1e-6);
}

TEST(OpenPath, EmptyCloudIsOpenToTheRange)
{
	const PointCloud cloud;
	AvoiderConfig config = evenClearance();
	config.max_range_m = 8.0;
	EXPECT_DOUBLE_EQ(OpenPath(onFloor(cloud), RobotConfig(), config).along(Direction{0.7}), 8.0);
}
}  // namespace
}  // namespace explore
