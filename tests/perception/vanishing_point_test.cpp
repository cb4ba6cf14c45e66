#include <explore/perception/vanishing_point.h>
#include <gtest/gtest.h>

#include <numbers>

#include "support/random_points.h"

namespace explore
{
namespace
{
const Plane kFloor{Eigen::Vector3d::UnitZ(), 0.0};
const Eigen::Vector3d kCamera(0.1, 0.0, 0.5);

/** A wall from `start` along `direction`, 2 m high. */
WallPatch wallAlong(const Eigen::Vector3d& start, const Eigen::Vector3d& direction, double length_m)
{
	std::mt19937 random(1);
	WallPatch patch;
	const Eigen::Vector3d normal = direction.cross(Eigen::Vector3d::UnitZ());
	patch.wall.plane = planeThrough(start, normal);
	if (patch.wall.plane.signedDistance(kCamera) < 0) patch.wall.plane = patch.wall.plane.flipped();
	test::addPatch(patch.inliers_in_robot, start, length_m * direction, {0, 0, 2}, 0.05, 0.0, random);
	patch.wall.inliers = patch.inliers_in_robot.size();
	patch.wall.floor_line = *intersectionLine(patch.wall.plane, kFloor, kCamera);
	return patch;
}

TEST(VanishingPoint, CorridorLeadsToOnePointAtItsFarEnd)
{
	for (const double yaw_deg : {-40.0, 0.0, 25.0})
	{
		const Eigen::AngleAxisd turn(yaw_deg * std::numbers::pi / 180, Eigen::Vector3d::UnitZ());
		const Eigen::Vector3d along = turn * Eigen::Vector3d::UnitX();
		const auto points = findVanishingPoints({wallAlong(turn * Eigen::Vector3d(1, 1, 0), along, 3.0),
		                                         wallAlong(turn * Eigen::Vector3d(1, -1, 0), along, 3.5)},
		                                        kFloor, kCamera, {});
		ASSERT_EQ(points.size(), 1U);
		EXPECT_LT((points[0].direction - along).norm(), 1e-6) << "the far side, not the one behind";
		EXPECT_EQ(points[0].walls, (std::vector<std::size_t>{0, 1}));
		const Eigen::Vector3d from_camera = points[0].point - kCamera;
		EXPECT_NEAR(from_camera.cross(along).norm(), 0.0, 1e-6) << "on the line through the camera";
		EXPECT_NEAR(along.dot(points[0].point), 4.5, 0.051) << "as far as the longer wall is seen";
	}
}

TEST(VanishingPoint, WallsAtAnAngleLeadToTwoPointsLargestFirst)
{
	const auto points = findVanishingPoints(
	    {wallAlong({1, 1, 0}, {1, 0, 0}, 2.0), wallAlong({4, -2, 0}, {0, 1, 0}, 4.0)}, kFloor, kCamera, {});
	ASSERT_EQ(points.size(), 2U);
	EXPECT_EQ(points[0].walls, (std::vector<std::size_t>{1}));
	EXPECT_EQ(points[1].walls, (std::vector<std::size_t>{0}));
	EXPECT_NEAR(std::abs(points[0].direction.y()), 1.0, 1e-6);
}

TEST(VanishingPoint, DirectionIsTheInlierWeightedMean)
{
	const double apart_rad = 6 * std::numbers::pi / 180;
	const auto points =
	    findVanishingPoints({wallAlong({1, 1, 0}, {1, 0, 0}, 3.0),
	                         wallAlong({1, -1, 0}, Eigen::Vector3d(std::cos(apart_rad), std::sin(apart_rad), 0), 1.5)},
	                        kFloor, kCamera, {});
	ASSERT_EQ(points.size(), 1U);
	EXPECT_NEAR(azimuthOf(points[0].direction), apart_rad / 3, 0.15 * apart_rad);
}

TEST(VanishingPoint, NoWallsNoPoint)
{
	EXPECT_TRUE(findVanishingPoints({}, kFloor, kCamera, {}).empty());
}
}  // namespace
}  // namespace explore
