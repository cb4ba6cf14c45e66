#include <explore/perception/walls.h>
#include <gtest/gtest.h>

#include <Eigen/QR>

#include "support/random_points.h"

namespace explore
{
namespace
{
const Plane kFloor{Eigen::Vector3d::UnitZ(), 0.0};
const Eigen::Vector3d kCamera(0.0, 0.0, 0.5);

std::vector<WallPatch> walls(const PointCloud& points, std::size_t filtered_count, const PlaneSearchConfig& planes = {})
{
	RandomEngine engine(1);
	return findWalls(points, filtered_count, kFloor, kCamera, {}, planes, engine);
}

TEST(IntersectionLine, EqualsLeastNormSolutionOnRandomPlanes)
{
	std::mt19937 random(21);
	for (int run = 0; run < 1000; ++run)
	{
		const Plane a{test::randomDirection(random), test::uniform(random, -3, 3)};
		const Plane b{test::randomDirection(random), test::uniform(random, -3, 3)};
		if (angleBetweenAxes(a.normal, b.normal) < 0.01) continue;
		const Eigen::Vector3d from = 4.0 * test::randomDirection(random);
		const auto line = intersectionLine(a, b, from);
		ASSERT_TRUE(line);

		// The same point without Lagrange: from + the shortest step that satisfies both plane equations.
		Eigen::Matrix<double, 2, 3> normals;
		normals << a.normal.transpose(), b.normal.transpose();
		const Eigen::Vector2d missing(-a.signedDistance(from), -b.signedDistance(from));
		const Eigen::Vector3d expected = from + normals.completeOrthogonalDecomposition().solve(missing);
		EXPECT_LT((line->point - expected).norm(), 1e-7) << "run " << run;

		for (const double s : {-2.0, 0.0, 5.0})  // the whole line lies in both planes
		{
			const Eigen::Vector3d on_line = line->point + s * line->direction;
			EXPECT_NEAR(a.signedDistance(on_line), 0.0, 1e-8);
			EXPECT_NEAR(b.signedDistance(on_line), 0.0, 1e-8);
			EXPECT_GE((on_line - from).norm(), (line->point - from).norm() - 1e-9);
		}
		EXPECT_NEAR(line->direction.norm(), 1.0, 1e-12);
	}
}

TEST(IntersectionLine, ParallelPlanesHaveNone)
{
	EXPECT_FALSE(intersectionLine(kFloor, {Eigen::Vector3d::UnitZ(), -2.5}, kCamera));
}

TEST(Walls, CorridorGivesBothWallsFacingTheCamera)
{
	std::mt19937 random(22);
	PointCloud points;
	test::addPatch(points, {1, 1.0, 0}, {4, 0, 0}, {0, 0, 2}, 0.05, 0.01, random);
	test::addPatch(points, {1, -1.2, 0}, {3, 0, 0}, {0, 0, 2}, 0.05, 0.01, random);
	const auto found = walls(points, points.size());
	ASSERT_EQ(found.size(), 2U);
	EXPECT_GT(found[0].wall.inliers, found[1].wall.inliers);
	EXPECT_LT((found[0].wall.plane.normal - Eigen::Vector3d(0, -1, 0)).norm(), 0.02);
	EXPECT_LT((found[1].wall.plane.normal - Eigen::Vector3d(0, 1, 0)).norm(), 0.02);
	EXPECT_NEAR(found[0].wall.plane.signedDistance(kCamera), 1.0, 0.02);
	EXPECT_NEAR(found[1].wall.plane.signedDistance(kCamera), 1.2, 0.02);
	EXPECT_LT((found[0].wall.floor_line.point - Eigen::Vector3d(0, 1.0, 0)).norm(), 0.05);
	for (const WallPatch& wall : found)
		for (std::size_t i = 0; i < wall.inliers_in_robot.size(); ++i)
			ASSERT_NEAR(wall.wall.plane.signedDistance(wall.inliers_in_robot[i].cast<double>()), 0.0, 1e-5);
}

TEST(Walls, SlopesAndCeilingsAreRemovedButNoWalls)
{
	std::mt19937 random(23);
	PointCloud points;
	test::addPatch(points, {1, -2, 2.4}, {3, 0, 0}, {0, 4, 0}, 0.05, 0.005, random);  // ceiling
	test::addPatch(points, {1, -2, 0.2}, {1, 0, 1}, {0, 2, 0}, 0.05, 0.005, random);  // 45° ramp
	test::addPatch(points, {4, -1, 0}, {0, 2, 0}, {0, 0, 2}, 0.05, 0.005, random);    // wall, the smallest but one
	const auto found = walls(points, points.size(), {.alpha = 0.0});
	ASSERT_EQ(found.size(), 1U);
	EXPECT_LT(angleBetweenAxes(found[0].wall.plane.normal, Eigen::Vector3d::UnitX()), 0.02);
}

TEST(Walls, ExtractionStopsAtAlpha)
{
	std::mt19937 random(24);
	PointCloud points;
	test::addPatch(points, {3, -2, 0}, {0, 4, 0}, {0, 0, 2}, 0.05, 0.0, random);   // 3321 points
	test::addPatch(points, {1, 2, 0}, {1.5, 0, 0}, {0, 0, 1}, 0.05, 0.0, random);  // 651: 16 %
	EXPECT_EQ(walls(points, points.size(), {.alpha = 0.2}).size(), 1U);
	EXPECT_EQ(walls(points, points.size(), {.alpha = 0.1}).size(), 2U);
	// What is left is compared with all filtered points, the ground's included.
	EXPECT_EQ(walls(points, 5 * points.size(), {.alpha = 0.2}).size(), 0U);
}
}  // namespace
}  // namespace explore
