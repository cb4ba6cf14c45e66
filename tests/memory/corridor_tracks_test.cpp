#include <explore/core/geometry.h>
#include <explore/memory/corridor_sight.h>
#include <explore/memory/corridor_tracks.h>
#include <gtest/gtest.h>
#include <support/analytic_scene.h>

#include "door_looks.h"

namespace explore::test
{
namespace
{
/** A corridor along `direction_rad` through `point_in_map`, seen by a robot in it. */
struct KnownCorridor
{
	Eigen::Vector2d point_in_map;
	double direction_rad, width_m;
};

struct Seen
{
	std::vector<VanishingPoint> points;
	std::vector<Wall> walls;
};

/** As perception reports it: two walls, and a point on the line through the camera, `length_m` ahead. */
Seen seen(const KnownCorridor& corridor, const Eigen::Isometry3d& map_from_robot, double length_m, Dice& dice)
{
	const Eigen::Isometry3d robot_from_map = map_from_robot.inverse();
	const double error_rad = 0.5 * kDegree_rad * dice.gauss();
	Eigen::Vector2d direction(std::cos(corridor.direction_rad + error_rad),
	                          std::sin(corridor.direction_rad + error_rad));
	if (direction.dot(map_from_robot.linear().col(0).head<2>()) < 0) direction = -direction;
	const Eigen::Vector2d camera = map_from_robot.translation().head<2>(), left(-direction.y(), direction.x());
	Seen result;
	for (const double side : {0.5, -0.5})
	{
		const double wall_m = left.dot(corridor.point_in_map - camera) + side * corridor.width_m + 0.02 * dice.gauss();
		const Eigen::Vector2d foot = camera + wall_m * left;
		Wall wall;
		wall.floor_line.point = robot_from_map * Eigen::Vector3d(foot.x(), foot.y(), 0);
		result.walls.push_back(wall);
	}
	VanishingPoint point;
	const Eigen::Vector2d end = camera + length_m * direction;
	point.point = robot_from_map * Eigen::Vector3d(end.x(), end.y(), 0.5);
	point.direction = robot_from_map.linear() * Eigen::Vector3d(direction.x(), direction.y(), 0);
	point.walls = {0, 1};
	result.points = {point};
	return result;
}

CorridorLook lookOf(const Seen& what, const Eigen::Isometry3d& map_from_robot, double t_s, double ahead_m = 6)
{
	return {what.points, what.walls, map_from_robot, mount(), t_s, ahead_m};
}

TEST(CorridorTracks, ADriveAlongACorridorIsOneConfirmedTrackOnItsMiddle)
{
	Dice dice(1);
	const KnownCorridor corridor{{0, 1}, 20 * kDegree_rad, 1.8};
	CorridorTracks tracks;
	for (int i = 0; i < 60; ++i)
	{
		const Eigen::Vector2d at =
		    corridor.point_in_map + 0.1 * i * Eigen::Vector2d(std::cos(20 * kDegree_rad), std::sin(20 * kDegree_rad));
		const auto map_from_robot = robotAt(at.x(), at.y() + 0.2, 15 * kDegree_rad);
		const auto numbers =
		    update(tracks, lookOf(seen(corridor, map_from_robot, 5, dice), map_from_robot, 0.2 * i), {});
		ASSERT_EQ(numbers, std::vector<int>{1});
		ASSERT_EQ(tracks.tracks.size(), 1U);
		EXPECT_EQ(tracks.tracks[0].existence.confirmed, i >= 2) << i;
	}
	const CorridorTrack& track = tracks.tracks[0];
	EXPECT_NEAR(track.direction_rad, 20 * kDegree_rad, 0.3 * kDegree_rad);
	EXPECT_NEAR(*track.width_m, 1.8, 0.05);
	const Eigen::Vector2d offset = track.point_in_map - corridor.point_in_map;
	EXPECT_NEAR(offset.dot(Eigen::Vector2d(-std::sin(20 * kDegree_rad), std::cos(20 * kDegree_rad))), 0, 0.05);
	EXPECT_NEAR(track.to_m - track.from_m, 10.9, 0.4);
}

TEST(CorridorTracks, TheWayBackIsTheSameCorridorAndItsCrossingIsAnother)
{
	Dice dice(2);
	const KnownCorridor along{{0, 0}, 0, 2}, across{{5, 0}, 90 * kDegree_rad, 2};
	CorridorTracks tracks;
	double t_s = 0;
	const auto drive = [&](const KnownCorridor& corridor, double x_m, double y_m, double yaw_rad)
	{
		const auto map_from_robot = robotAt(x_m, y_m, yaw_rad);
		return update(tracks, lookOf(seen(corridor, map_from_robot, 4, dice), map_from_robot, t_s += 0.2), {}).at(0);
	};
	for (int i = 0; i < 10; ++i) EXPECT_EQ(drive(along, 0.3 * i, 0, 0), 1);
	for (int i = 0; i < 10; ++i) EXPECT_EQ(drive(across, 5, 0.2 * i, 90 * kDegree_rad), 2);
	for (int i = 0; i < 10; ++i) EXPECT_EQ(drive(along, 5 - 0.3 * i, 0, 180 * kDegree_rad), 1);
	ASSERT_EQ(tracks.tracks.size(), 2U);
	EXPECT_NEAR(tracks.tracks[0].direction_rad, 0, 0.01) << "as it was first seen";
}

TEST(CorridorTracks, ParallelCorridorsAreTwo)
{
	Dice dice(3);
	const KnownCorridor near{{0, 0}, 0, 2}, far{{0, 4}, 0, 2};
	CorridorTracks tracks;
	for (int i = 0; i < 5; ++i)
	{
		const auto here = robotAt(0.3 * i, 0, 0), there = robotAt(0.3 * i, 4, 0);
		EXPECT_EQ(update(tracks, lookOf(seen(near, here, 5, dice), here, i), {}).at(0), 1);
		EXPECT_EQ(update(tracks, lookOf(seen(far, there, 5, dice), there, i + 0.5), {}).at(0), 2);
	}
}

TEST(CorridorTracks, PiecesOfOneCorridorBecomeOneWhenTheGapIsSeen)
{
	Dice dice(4);
	const KnownCorridor corridor{{0, 0}, 0, 2};
	CorridorTracks tracks;
	double t_s = 0;
	const auto look_from = [&](double x_m, double length_m)
	{
		const auto map_from_robot = robotAt(x_m, 0, 0);
		return update(tracks, lookOf(seen(corridor, map_from_robot, length_m, dice), map_from_robot, t_s += 1), {})
		    .at(0);
	};
	EXPECT_EQ(look_from(0, 3), 1);
	EXPECT_EQ(look_from(12, 3), 2) << "9 m further on";
	EXPECT_EQ(look_from(12.1, 3), 2);
	EXPECT_EQ(look_from(4, 6), 1) << "what lies between";
	ASSERT_EQ(tracks.tracks.size(), 1U);
	EXPECT_NEAR(tracks.tracks[0].to_m - tracks.tracks[0].from_m, 15.1, 0.3);
}

TEST(CorridorTracks, OneThatShouldBeSeenAndIsNotDies)
{
	Dice dice(5);
	const KnownCorridor corridor{{0, 0}, 0, 2};
	CorridorTracks tracks;
	for (int i = 0; i < 3; ++i)
	{
		const auto map_from_robot = robotAt(0.3 * i, 0, 0);
		update(tracks, lookOf(seen(corridor, map_from_robot, 7, dice), map_from_robot, i), {});
	}
	ASSERT_TRUE(tracks.tracks.at(0).existence.confirmed);
	const Seen nothing;
	for (int i = 0; i < 20; ++i) update(tracks, lookOf(nothing, robotAt(0.9, 0.03 * i, 80 * kDegree_rad), 10 + i), {});
	ASSERT_EQ(tracks.tracks.size(), 1U) << "looked elsewhere";
	for (int i = 0; i < 20; ++i) update(tracks, lookOf(nothing, robotAt(0.9, 0, 0), 40 + i, 1.0), {});
	ASSERT_EQ(tracks.tracks.size(), 1U) << "someone stands before the camera";
	for (int i = 0; i < 20; ++i) update(tracks, lookOf(nothing, robotAt(0.9 + 0.02 * i, 0, 0), 70 + i), {});
	EXPECT_TRUE(tracks.tracks.empty());
}

TEST(CorridorTracks, ACorrectionMovesThemAndTheyGoOn)
{
	Dice dice(6);
	const KnownCorridor corridor{{0, 0}, 0, 2};
	CorridorTracks tracks;
	const auto drive = [&](const Eigen::Isometry3d& moved, int from)
	{
		const KnownCorridor now{(moved * Eigen::Vector3d(0, 0, 0)).head<2>(), corridor.direction_rad + turnOf(moved),
		                        2};
		for (int i = from; i < from + 10; ++i)
		{
			const Eigen::Isometry3d map_from_robot = moved * robotAt(0.2 * i, 0.1, 0);
			EXPECT_EQ(update(tracks, lookOf(seen(now, map_from_robot, 5, dice), map_from_robot, i), {}).at(0), 1);
		}
	};
	drive(Eigen::Isometry3d::Identity(), 0);
	const Eigen::Isometry3d correction = robotAt(0.4, -0.3, 10 * kDegree_rad);
	correct(tracks, correction);
	drive(correction, 10);
	ASSERT_EQ(tracks.tracks.size(), 1U);
	EXPECT_NEAR(tracks.tracks[0].direction_rad, 10 * kDegree_rad, 0.5 * kDegree_rad);
}

TEST(CorridorTracks, ConfirmedOnesAreVanishingPointsToEitherEndForARobotInThem)
{
	Dice dice(7);
	const KnownCorridor corridor{{0, 0}, 0, 2};
	CorridorTracks tracks;
	for (int i = 0; i < 5; ++i)
	{
		const auto map_from_robot = robotAt(0.5 * i, 0.3, 0);
		update(tracks, lookOf(seen(corridor, map_from_robot, 5, dice), map_from_robot, i), {});
	}
	const auto points = confirmedCorridors(tracks, robotAt(3, 0.2, 90 * kDegree_rad).inverse());
	ASSERT_EQ(points.size(), 2U);
	EXPECT_LT((points[0].point - Eigen::Vector3d(-0.2, 3, 0.5)).norm(), 0.2) << "back, to where it was first seen from";
	EXPECT_LT((points[1].point - Eigen::Vector3d(-0.2, -4, 0.5)).norm(), 0.2)
	    << "on, to the right of a robot turned left";
	EXPECT_NEAR(points[1].direction.y(), -1, 1e-3);
	EXPECT_EQ(points[1].track, 1);
	EXPECT_TRUE(confirmedCorridors(tracks, robotAt(3, 3, 0).inverse()).empty()) << "beside it";
}

TEST(CorridorSight, TellsHowFarTheWayAheadIsClear)
{
	const auto ahead = [](const Scene& scene, double yaw_rad)
	{
		return clearAhead(renderFrame(scene, mrpt::poses::CPose3D(0, 0, 0, yaw_rad, 0, 0),
		                              mrpt::poses::CPose3D(0, 0, 0.5, 0, 0, 0), xtionIntrinsics(160, 120)));
	};
	Scene scene = corridorScene(7, {}, {});
	EXPECT_NEAR(ahead(scene, 0), 7, 0.01);
	EXPECT_LT(ahead(scene, 60 * kDegree_rad), 2.5);
	EXPECT_EQ(ahead(corridorScene(30, {}, {}), 0), 0) << "no return from beyond 8 m";
	scene.box({2.0, 0, 0.9}, {0.4, 0.5, 1.8});
	EXPECT_NEAR(ahead(scene, 0), 1.8, 0.01) << "somebody in the way";
	EXPECT_EQ(clearAhead(DepthFrame()), 0);
}
}  // namespace
}  // namespace explore::test
