#include <explore/perception/planes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_points.h"

namespace explore
{
namespace
{
/** Two vectors that span the plane with this normal. */
std::pair<Eigen::Vector3d, Eigen::Vector3d> spanOf(const Eigen::Vector3d& normal)
{
	const Eigen::Vector3d u = normal.unitOrthogonal();
	return {u, normal.cross(u)};
}

struct NoisyPlane
{
	Plane truth;
	PointCloud points;
};

NoisyPlane randomNoisyPlane(std::mt19937& random, std::size_t outliers)
{
	NoisyPlane result;
	const Eigen::Vector3d normal = test::randomDirection(random);
	const Eigen::Vector3d corner = test::uniform(random, -2, 2) * test::randomDirection(random);
	result.truth = planeThrough(corner, normal);
	const auto [u, v] = spanOf(normal);
	test::addPatch(result.points, corner, 2.0 * u, 2.0 * v, 0.05, 0.01, random);
	test::addUniform(result.points, outliers, 3.0, random);
	return result;
}

TEST(DominantPlane, FindsThePlaneAmongAsManyOutliers)
{
	std::mt19937 random(5);
	for (int run = 0; run < 40; ++run)
	{
		const NoisyPlane data = randomNoisyPlane(random, 1700);
		RandomEngine engine(1);
		const auto found = dominantPlane(data.points, {}, engine);
		ASSERT_TRUE(found) << "run " << run;
		// Outliers within tolerance cannot be told from the plane: they cost up to a degree.
		EXPECT_LT(angleBetweenAxes(found->plane.normal, data.truth.normal), 0.02) << "run " << run;
		EXPECT_GT(found->inliers.size(), 1600U) << "run " << run;
	}
}

TEST(DominantPlane, InliersAreExactlyThePointsWithinTolerance)
{
	std::mt19937 random(6);
	const NoisyPlane data = randomNoisyPlane(random, 3000);
	RandomEngine engine(1);
	const auto found = dominantPlane(data.points, {}, engine);
	ASSERT_TRUE(found);
	std::vector<std::uint32_t> expected;
	for (std::uint32_t i = 0; i < data.points.size(); ++i)
		if (std::abs(found->plane.signedDistance(data.points[i].cast<double>())) <= 0.05) expected.push_back(i);
	// Single against double precision may differ for a point on the border.
	std::vector<std::uint32_t> difference;
	std::ranges::set_symmetric_difference(expected, found->inliers, std::back_inserter(difference));
	EXPECT_LE(difference.size(), 1U);
	EXPECT_TRUE(std::ranges::is_sorted(found->inliers));
}

TEST(DominantPlane, SameSeedSamePlane)
{
	std::mt19937 random(8);
	const NoisyPlane data = randomNoisyPlane(random, 2000);
	RandomEngine first(42), second(42);
	const auto a = dominantPlane(data.points, {}, first), b = dominantPlane(data.points, {}, second);
	ASSERT_TRUE(a && b);
	EXPECT_EQ(a->plane.normal, b->plane.normal);
	EXPECT_EQ(a->inliers, b->inliers);
}

TEST(DominantPlane, ConeLeavesOutALargerPlane)
{
	std::mt19937 random(9);
	PointCloud points;
	test::addPatch(points, {2, -2, 0}, {0, 4, 0}, {0, 0, 2.5}, 0.05, 0.005, random);  // wall: 4050 points
	test::addPatch(points, {0.5, -1, 0}, {1, 0, 0}, {0, 2, 0}, 0.05, 0.005, random);  // floor: 860
	RandomEngine engine(1);
	const auto wall = dominantPlane(points, {}, engine);
	const auto floor = dominantPlane(points, {}, engine, NormalCone{Eigen::Vector3d::UnitZ(), 0.26});
	ASSERT_TRUE(wall && floor);
	EXPECT_LT(angleBetweenAxes(wall->plane.normal, Eigen::Vector3d::UnitX()), 0.02);
	EXPECT_LT(angleBetweenAxes(floor->plane.normal, Eigen::Vector3d::UnitZ()), 0.02);
	EXPECT_NEAR(std::abs(floor->plane.d_m), 0.0, 0.01);
}

TEST(DominantPlane, TooFewPointsAreNoPlane)
{
	std::mt19937 random(10);
	PointCloud points;
	test::addPatch(points, {1, 0, 0}, {0.3, 0, 0}, {0, 0.3, 0}, 0.05, 0.0, random);  // 49 points
	RandomEngine engine(1);
	EXPECT_FALSE(dominantPlane(points, {}, engine));
	EXPECT_FALSE(dominantPlane(PointCloud{}, {}, engine));
}

TEST(DominantPlane, PointsOnOneLineOrOneSpotAreNoPlane)
{
	PointCloud line, spot;
	for (int i = 0; i < 200; ++i)
	{
		line.push_back({0.01F * static_cast<float>(i), 0.0F, 0.0F});
		spot.push_back({1.0F, 1.0F, 1.0F});
	}
	RandomEngine engine(1);
	EXPECT_FALSE(dominantPlane(line, {}, engine));
	EXPECT_FALSE(dominantPlane(spot, {}, engine));
}

TEST(FitPlane, NoOtherPlaneHasASmallerSumOfSquares)
{
	std::mt19937 random(12);
	const NoisyPlane data = randomNoisyPlane(random, 0);
	std::vector<std::uint32_t> all(data.points.size());
	for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
	const auto squares = [&](const Plane& plane)
	{
		double sum = 0;
		for (const auto i : all) sum += std::pow(plane.signedDistance(data.points[i].cast<double>()), 2);
		return sum;
	};
	const Plane fitted = fitPlane(data.points, all);
	const double best = squares(fitted);
	for (int run = 0; run < 500; ++run)
	{
		const Eigen::Vector3d normal = fitted.normal + 0.02 * test::randomDirection(random);
		const Plane other{normal.normalized(), fitted.d_m + test::uniform(random, -0.02, 0.02)};
		EXPECT_GE(squares(other), best);
	}
}

TEST(ProjectOnto, PointsLieInThePlaneAndMovedAlongItsNormal)
{
	std::mt19937 random(13);
	const NoisyPlane data = randomNoisyPlane(random, 500);
	std::vector<std::uint32_t> some{0, 3, 17, 2000};
	const PointCloud projected = projectOnto(data.truth, data.points, some);
	ASSERT_EQ(projected.size(), some.size());
	for (std::size_t k = 0; k < some.size(); ++k)
	{
		EXPECT_NEAR(data.truth.signedDistance(projected[k].cast<double>()), 0.0, 1e-6);
		const Eigen::Vector3d moved = (projected[k] - data.points[some[k]]).cast<double>();
		EXPECT_LT(moved.cross(data.truth.normal).norm(), 1e-5);
	}
}

TEST(Without, KeepsTheOthersInOrder)
{
	PointCloud points;
	for (int i = 0; i < 6; ++i) points.push_back({static_cast<float>(i), 0, 0});
	const PointCloud rest = without(points, {0, 2, 5});
	EXPECT_EQ(rest.x, (std::vector<float>{1, 3, 4}));
	EXPECT_EQ(without(points, {}).size(), 6U);
}
}  // namespace
}  // namespace explore
