#include <explore/perception/obstacles.h>
#include <explore/perception/range_filter.h>
#include <explore/perception/sight_lines.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/analytic_scene.h"

namespace explore
{
namespace
{
using mrpt::poses::CPose3D;
using test::Scene;
const CPose3D kMount(0.1, 0.0, 0.5, 0, 0, 0);
const Plane kFloor{Eigen::Vector3d::UnitZ(), 0.0};

DepthFrame look(const Scene& scene, const test::CameraNoise& noise = {}, const CPose3D& mount = kMount)
{
	return test::renderFrame(scene, {}, mount, test::xtionIntrinsics(), noise);
}

RobotConfig mav()
{
	RobotConfig robot;
	robot.kind = RobotKind::mav;
	return robot;
}

PointCloud obstaclesOf(const DepthFrame& frame, const RobotConfig& robot = {})
{
	return nearObstacles(frame, kFloor, robot, {}, {});
}

Scene bareFloor()
{
	Scene scene;
	scene.floor(-2, -6, 9, 6);
	return scene;
}

/** Points within 3 cm of an upright line. */
std::size_t countAt(const PointCloud& cloud, double x, double y)
{
	std::size_t count = 0;
	for (std::size_t i = 0; i < cloud.size(); ++i) count += std::hypot(cloud.x[i] - x, cloud.y[i] - y) < 0.03 ? 1 : 0;
	return count;
}

TEST(NearObstacles, AThinPoleIsSeen)
{
	for (const double y : {-0.6, 0.0, 0.37})
	{
		Scene scene = bareFloor();
		scene.box({2.01, y, 0.4}, {0.02, 0.02, 0.8});
		const PointCloud found = obstaclesOf(look(scene, {.axial_scale = 1.0, .seed = 3}));
		EXPECT_GE(countAt(found, 2.0, y), 3U) << y;
	}
}

TEST(NearObstacles, ANoisyFloorIsNone)
{
	for (const double height : {0.3, 0.5, 1.2})
		for (const std::uint32_t seed : {1U, 2U, 3U})
		{
			const auto frame =
			    look(bareFloor(), {.axial_scale = 1.0, .seed = seed}, CPose3D(0.1, 0, height, 0, 0.1, 0));
			EXPECT_EQ(obstaclesOf(frame).size(), 0U) << "camera " << height << " m up, seed " << seed;
		}
}

TEST(NearObstacles, StrayPixelsAreNone)
{
	DepthFrame frame = look(bareFloor());
	std::mt19937 random(5);
	const std::size_t width = 640;
	for (int i = 0; i < 2000; ++i)
		frame.image.depth_m[random() % frame.image.depth_m.size()] =
		    0.5F + 3.0F * static_cast<float>(random() % 1000) / 1000.0F;
	// A silhouette's pixels, each at another depth between near and far.
	for (std::size_t v = 0; v < 300; ++v)
		frame.image.depth_m[v * width + 320] = 0.8F + 3.0F * static_cast<float>(random() % 1000) / 1000.0F;
	EXPECT_LE(obstaclesOf(frame).size(), 5U);
}

TEST(NearObstacles, ABlobOfNoiseIsNoneAndAThingOfItsSizeFarAwayIsOne)
{
	for (const float depth : {0.6F, 3.0F})
	{
		DepthFrame frame = look(bareFloor());
		for (std::size_t v = 250; v < 256; ++v)
			for (std::size_t u = 300; u < 308; ++u) frame.image.depth_m[v * 640 + u] = depth;
		EXPECT_EQ(!obstaclesOf(frame).empty(), depth > 1.0F) << depth;
	}
}

TEST(NearObstacles, HeightDecidesOnTheGroundAndNotInTheAir)
{
	struct Case
	{
		double bottom, top;
		bool counts;
	};
	for (const Case& c : {Case{0.0, 0.03, false}, {0.0, 0.12, true}, {0.55, 0.7, true}, {0.75, 1.0, false}})
	{
		Scene scene = bareFloor();
		scene.box({2.2, 0, 0.5 * (c.bottom + c.top)}, {0.4, 0.6, c.top - c.bottom});
		const DepthFrame frame = look(scene);
		EXPECT_EQ(!obstaclesOf(frame).empty(), c.counts) << c.bottom << " to " << c.top;
		EXPECT_GT(obstaclesOf(frame, mav()).size(), 100U);
	}
}

TEST(NearObstacles, ADropIsOneAndAStepOfThreeCentimetresIsNot)
{
	for (const double depth : {0.03, 0.18, 1.5})
	{
		Scene scene;
		scene.floor(-2, -6, 2, 6).floor(2, -6, 9, 6, -depth);
		const PointCloud found = obstaclesOf(look(scene, {.axial_scale = 1.0}));
		EXPECT_EQ(!found.empty(), depth > 0.1) << depth;
		for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LT(found.z[i], -0.05F);
	}
}

TEST(NearObstacles, NothingBeyondTheRange)
{
	Scene scene = bareFloor();
	scene.wall({5.6, -4}, {5.6, 4}, 2.5);
	EXPECT_EQ(obstaclesOf(look(scene)).size(), 0U);
	EXPECT_EQ(nearObstacles(look(scene), kFloor, {}, {.max_range_m = 6.0}, {}).size() > 100U, true);
}

/** The least distance of a point from the swept disc's way, as an open path, over every point there is. */
double openPath(const PointCloud& cloud, double azimuth, double radius)
{
	double open = 5.0;
	for (std::size_t i = 0; i < cloud.size(); ++i)
	{
		const double ahead = cloud.x[i] * std::cos(azimuth) + cloud.y[i] * std::sin(azimuth);
		const double aside = cloud.y[i] * std::cos(azimuth) - cloud.x[i] * std::sin(azimuth);
		if (ahead > 0.0 && std::abs(aside) < radius)
			open = std::min(open, std::max(0.0, ahead - std::sqrt(radius * radius - aside * aside)));
	}
	return open;
}

TEST(NearObstacles, TilesLoseNothingThatShortensAWay)
{
	std::mt19937 random(11);
	const auto uniform = [&](double low, double high)
	{ return low + (high - low) * static_cast<double>(random() % 10000) / 10000.0; };
	for (int trial = 0; trial < 12; ++trial)
	{
		Scene scene = bareFloor();
		scene.wall({5.5, -4}, {5.5, 4}, 2.5);
		for (int i = 0; i < 6; ++i)
		{
			const double height = uniform(0.1, 1.5), size = uniform(0.03, 0.6);
			scene.box({uniform(1.0, 4.5), uniform(-2, 2), 0.5 * height}, {size, size, height});
		}
		const DepthFrame frame =
		    look(scene, {}, CPose3D(0.1, 0, uniform(0.3, 1.2), 0, uniform(-0.1, 0.2), uniform(-0.1, 0.1)));
		const PointCloud every_point = rangeFilter(frame, {5.0});
		PointCloud standing;
		for (std::size_t i = 0; i < every_point.size(); ++i)
			if (every_point.z[i] > 0.08F && every_point.z[i] < 0.65F) standing.push_back(every_point[i]);
		const PointCloud found = obstaclesOf(frame);
		EXPECT_LT(found.size(), 6000U);
		for (double azimuth = -0.4; azimuth < 0.41; azimuth += 0.1)
		{
			// A tile's width of play at the hull's edge.
			EXPECT_LE(openPath(found, azimuth, 0.25), openPath(standing, azimuth, 0.23) + 0.03)
			    << trial << ", " << azimuth;
			EXPECT_GE(openPath(found, azimuth, 0.25),
			          openPath(every_point, azimuth, 0.27) - 0.03 - 5.0 * (found.empty() ? 1 : 0));
		}
	}
}

TEST(NearObstacles, WithoutAFloorAGroundRobotStandsOnItsFramesPlane)
{
	Scene scene = bareFloor();
	EXPECT_TRUE(nearObstacles(look(scene), std::nullopt, {}, {}, {}).empty());
	scene.box({2, 0, 0.2}, {0.3, 0.3, 0.4});
	EXPECT_FALSE(nearObstacles(look(scene), std::nullopt, {}, {}, {}).empty());
}

TEST(NearObstacles, AnUnorganisedCloudIsSortedByHeightToo)
{
	DepthFrame frame;
	frame.robot_from_camera = kMount;
	for (const float z : {-0.9F, -0.5F, -0.2F, 0.4F}) frame.points_in_camera.push_back({2.0F, 0.0F, z});
	const PointCloud found = nearObstacles(frame, kFloor, {}, {}, {});
	ASSERT_EQ(found.size(), 2U);  // the drop and what stands 0.3 m high; not the floor, not the lamp
	EXPECT_EQ(nearObstacles(frame, kFloor, mav(), {}, {}).size(), 4U);
}

TEST(SightLines, SeesWhatTheImageHolds)
{
	const SightLines lines = sightLines(look(bareFloor()));
	EXPECT_EQ(lines.size(), lines.columns * (lines.size() / lines.columns));
	EXPECT_TRUE(lines.sees({1, 0, 0}));
	EXPECT_TRUE(lines.sees({1, 0.5, 0}));
	EXPECT_FALSE(lines.sees({1, 0.6, 0}));
	EXPECT_FALSE(lines.sees({1, 0, 0.5}));
	EXPECT_FALSE(lines.sees({-1, 0, 0}));
	EXPECT_TRUE(sightLines(DepthFrame()).empty());
}
}  // namespace
}  // namespace explore
