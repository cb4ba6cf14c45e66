#include <explore/core/geometry.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/random_points.h"

namespace explore
{
namespace
{
constexpr double kPi = std::numbers::pi;

TEST(Plane, SignedDistanceIsThePapersEquationTwo)
{
	std::mt19937 random(1);
	for (int run = 0; run < 500; ++run)
	{
		// Any a, b, c, d; the paper divides by the normal's length, planeThrough() makes it 1.
		const Eigen::Vector3d abc = 3.0 * test::randomDirection(random) * test::uniform(random, 0.1, 2.0);
		const Eigen::Vector3d on_plane = 2.0 * test::randomDirection(random), q = 5.0 * test::randomDirection(random);
		const double d = -(abc.x() * on_plane.x() + abc.y() * on_plane.y() + abc.z() * on_plane.z());
		const double expected = (abc.x() * q.x() + abc.y() * q.y() + abc.z() * q.z() + d) / abc.norm();
		const Plane plane = planeThrough(on_plane, abc);
		EXPECT_NEAR(plane.signedDistance(q), expected, 1e-12);
		EXPECT_NEAR(plane.flipped().signedDistance(q), -expected, 1e-12);
		EXPECT_NEAR(plane.signedDistance(plane.project(q)), 0.0, 1e-12);
		EXPECT_NEAR((plane.project(q) - q).norm(), std::abs(expected), 1e-12);
	}
}

TEST(AngleBetweenAxes, IgnoresSignsAndKeepsPrecisionNearZero)
{
	const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
	EXPECT_DOUBLE_EQ(angleBetweenAxes(x, -x), 0.0);
	EXPECT_DOUBLE_EQ(angleBetweenAxes(x, Eigen::Vector3d::UnitZ()), kPi / 2);
	EXPECT_NEAR(angleBetweenAxes(x, {1.0, 1e-9, 0.0}), 1e-9, 1e-15);
	EXPECT_NEAR(angleBetweenAxes({-2, 2, 0}, {0, 5, 0}), kPi / 4, 1e-15);
}

TEST(WrapToPi, StaysInTheHalfOpenInterval)
{
	EXPECT_DOUBLE_EQ(wrapToPi(kPi), kPi);
	EXPECT_DOUBLE_EQ(wrapToPi(-kPi), kPi);
	EXPECT_DOUBLE_EQ(wrapToPi(0.0), 0.0);
	for (double angle = -20.0; angle < 20.0; angle += 0.37)
	{
		const double wrapped = wrapToPi(angle);
		EXPECT_GT(wrapped, -kPi);
		EXPECT_LE(wrapped, kPi);
		EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-12);
		EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-12);
	}
}

TEST(AzimuthOf, IsPositiveToTheLeft)
{
	EXPECT_DOUBLE_EQ(azimuthOf({1, 0, 7}), 0.0);
	EXPECT_DOUBLE_EQ(azimuthOf({0, 1, 0}), kPi / 2);
	EXPECT_DOUBLE_EQ(azimuthOf({0, -1, 0}), -kPi / 2);
	EXPECT_DOUBLE_EQ(azimuthOf({-1, -0.0, 0}), kPi);
}

TEST(IsometryOf, EqualsMrptsPoseComposition)
{
	std::mt19937 random(2);
	for (int run = 0; run < 100; ++run)
	{
		const mrpt::poses::CPose3D b_from_a(test::uniform(random, -2, 2), test::uniform(random, -2, 2),
		                                    test::uniform(random, -2, 2), test::uniform(random, -3, 3),
		                                    test::uniform(random, -1.5, 1.5), test::uniform(random, -3, 3));
		const Eigen::Vector3d in_a = 4.0 * test::randomDirection(random);
		Eigen::Vector3d in_b;
		b_from_a.composePoint(in_a.x(), in_a.y(), in_a.z(), in_b.x(), in_b.y(), in_b.z());
		EXPECT_LT((isometryOf(b_from_a) * in_a - in_b).norm(), 1e-12);
	}
}

TEST(IsometryOf, PositivePitchLooksDown)
{
	const mrpt::poses::CPose3D robot_from_camera(0, 0, 0, 0, 0.3, 0);
	EXPECT_NEAR((isometryOf(robot_from_camera) * Eigen::Vector3d::UnitX()).z(), -std::sin(0.3), 1e-12);
}
}  // namespace
}  // namespace explore
