#include <explore/core/geometry.h>
#include <explore/memory/door_tracks.h>
#include <gtest/gtest.h>

#include "door_looks.h"

namespace explore::test
{
namespace
{
const RobotConfig kRobot;
const DoorTrackConfig kConfig;
const KnownDoor kDoor{{3, 0}, std::numbers::pi};

/** Looks from places 0.3 m apart, sideways, from 3 m away. */
class Scout
{
public:
	std::vector<int> look(const std::vector<Door>& doors_in_robot)
	{
		return update(tracks, lookAt(doors_in_robot, where(), t_s), kRobot, kConfig);
	}
	std::vector<int> lookAtDoors(const std::vector<KnownDoor>& doors)
	{
		++step;
		t_s += 0.5;
		std::vector<Door> reports;
		for (const KnownDoor& door : doors) reports.push_back(reportOf(door, where()));
		return look(reports);
	}
	void lookAtDoors(const std::vector<KnownDoor>& doors, int times)
	{
		for (int i = 0; i < times; ++i) lookAtDoors(doors);
	}
	[[nodiscard]] Eigen::Isometry3d where() const { return moved * robotAt(0, step % 2 == 0 ? 0.15 : -0.15, 0); }

	DoorTracks tracks;
	Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
	int step = 0;
	double t_s = 0;
};

KnownDoor with(KnownDoor door, Verdict verdict)
{
	door.verdict = verdict;
	return door;
}

TEST(DoorTracks, ThreeLooksConfirmADoor)
{
	Scout scout;
	EXPECT_EQ(scout.lookAtDoors({kDoor}), std::vector<int>{1});
	EXPECT_FALSE(scout.tracks.tracks.at(0).existence.confirmed);
	scout.lookAtDoors({kDoor}, 2);
	EXPECT_TRUE(scout.tracks.tracks.at(0).existence.confirmed);
	const auto doors = confirmedDoors(scout.tracks, robotAt(1, 0, 0).inverse());
	ASSERT_EQ(doors.size(), 1U);
	EXPECT_LT((doors[0].center - Eigen::Vector3d(2, 0, 1)).norm(), 1e-6);
	EXPECT_NEAR(doors[0].normal.x(), -1, 1e-9);
	EXPECT_EQ(doors[0].verdict, Verdict::open);
	EXPECT_EQ(doors[0].track, 1);
	EXPECT_NEAR(confirmedDoors(scout.tracks, robotAt(5, 0, 0).inverse()).at(0).normal.x(), 1, 1e-9) << "from behind";
}

TEST(DoorTracks, FramesBetweenLooksAreNumberedButDoNotCount)
{
	Scout scout;
	scout.lookAtDoors({kDoor});
	for (int i = 0; i < 10; ++i)
	{
		scout.t_s += 0.01;
		EXPECT_EQ(scout.look({reportOf(kDoor, scout.where())}), std::vector<int>{1});
	}
	EXPECT_EQ(scout.tracks.tracks.at(0).existence.looks, 1);
}

TEST(DoorTracks, AFalseAlarmIsForgotten)
{
	Scout scout;
	scout.lookAtDoors({kDoor});
	scout.lookAtDoors({}, 2);
	EXPECT_TRUE(confirmedDoors(scout.tracks, Eigen::Isometry3d::Identity()).empty());
	scout.lookAtDoors({}, 20);
	EXPECT_TRUE(scout.tracks.tracks.empty());
}

TEST(DoorTracks, OutOfSightIsNotOutOfMind)
{
	Scout scout;
	scout.lookAtDoors({kDoor}, 4);
	for (int i = 0; i < 100; ++i)
		update(scout.tracks, lookAt({}, robotAt(0, 0, std::numbers::pi), 100 + i), kRobot, kConfig);
	EXPECT_TRUE(scout.tracks.tracks.at(0).existence.confirmed);
	scout.lookAtDoors({}, 20);
	EXPECT_TRUE(scout.tracks.tracks.empty()) << "but a place where it should be seen and is not";
}

TEST(DoorTracks, AnUnconfirmedOneOutOfSightIsForgottenWithTimeOrWay)
{
	Scout by_time, by_way;
	by_time.lookAtDoors({kDoor}, 2);
	by_way.lookAtDoors({kDoor}, 2);
	update(by_time.tracks, lookAt({}, robotAt(0, 0, std::numbers::pi), 50), kRobot, kConfig);
	EXPECT_EQ(by_time.tracks.tracks.size(), 1U);
	update(by_time.tracks, lookAt({}, robotAt(0, 0, std::numbers::pi), 70), kRobot, kConfig);
	EXPECT_TRUE(by_time.tracks.tracks.empty());
	update(by_way.tracks, lookAt({}, robotAt(-4, 0, std::numbers::pi), 5), kRobot, kConfig);
	EXPECT_EQ(by_way.tracks.tracks.size(), 1U);
	update(by_way.tracks, lookAt({}, robotAt(-6, 0, std::numbers::pi), 6), kRobot, kConfig);
	EXPECT_TRUE(by_way.tracks.tracks.empty());
}

TEST(DoorTracks, ADoorThatIsShutIsBelievedAfterSomeLooks)
{
	Scout scout;
	scout.lookAtDoors({kDoor}, 20);
	scout.lookAtDoors({with(kDoor, Verdict::closed)});
	EXPECT_EQ(verdictOf(scout.tracks.tracks.at(0)), Verdict::open);
	scout.lookAtDoors({with(kDoor, Verdict::closed)}, 9);
	EXPECT_EQ(verdictOf(scout.tracks.tracks.at(0)), Verdict::closed);
	EXPECT_TRUE(scout.tracks.tracks.at(0).existence.confirmed);
	scout.lookAtDoors({kDoor}, 10);
	EXPECT_EQ(verdictOf(scout.tracks.tracks.at(0)), Verdict::open);
	EXPECT_EQ(scout.tracks.tracks.at(0).number, 1);
}

TEST(DoorTracks, AFlushLeafOfWhichThereIsNoReportShutsItToo)
{
	Scout scout;
	scout.lookAtDoors({kDoor}, 20);
	int looks = 0;
	for (; looks < 20 && !scout.tracks.tracks.empty() && isPassable(verdictOf(scout.tracks.tracks[0])); ++looks)
	{
		++scout.step;
		scout.t_s += 0.5;
		DoorLook look = lookAt({}, scout.where(), scout.t_s);
		look.view = [](const DoorPlace&) { return std::optional(DoorView{0, 1}); };
		update(scout.tracks, look, kRobot, kConfig);
	}
	EXPECT_GE(looks, 2);
	EXPECT_LE(looks, 8);
}

TEST(DoorTracks, AnOpeningThatIsSeenThroughOutlivesManyMissingReports)
{
	Scout through, shut;
	through.lookAtDoors({kDoor}, 5);
	shut.lookAtDoors({kDoor}, 5);
	int lived_through = 0, lived_shut = 0;
	for (int i = 0; i < 60; ++i)
	{
		++through.step;
		through.t_s += 0.5;
		DoorLook look = lookAt({}, through.where(), through.t_s);
		look.view = [](const DoorPlace&) { return std::optional(DoorView{1, 0}); };
		update(through.tracks, look, kRobot, kConfig);
		look.view = [](const DoorPlace&) { return std::optional(DoorView{0, 0}); };
		update(shut.tracks, look, kRobot, kConfig);
		lived_through += through.tracks.tracks.empty() ? 0 : 1;
		lived_shut += shut.tracks.tracks.empty() ? 0 : 1;
	}
	EXPECT_GT(lived_through, lived_shut + lived_shut / 2);
}

TEST(DoorTracks, DoorsSideBySideStayTwoAndReportsOfOneBecomeOne)
{
	const KnownDoor left{{3, 0.45}, std::numbers::pi, 0.8}, right{{3, -0.45}, std::numbers::pi, 0.8};
	Scout scout;
	Dice dice(2);
	for (int i = 0; i < 30; ++i)
	{
		++scout.step;
		scout.t_s += 0.5;
		const std::vector<int> numbers =
		    scout.look({noisyReport(left, scout.where(), dice), noisyReport(right, scout.where(), dice)});
		ASSERT_EQ(numbers, (std::vector<int>{1, 2})) << i;
	}
	EXPECT_EQ(scout.tracks.tracks.size(), 2U);

	Scout other;
	KnownDoor off = kDoor;
	off.center_in_map += Eigen::Vector2d(0.45, 0.1);
	other.lookAtDoors({kDoor}, 3);
	other.tracks.tracks[0].center_covariance *= 1e-3;
	other.lookAtDoors({off}, 3);
	ASSERT_EQ(other.tracks.tracks.size(), 2U) << "too far behind to be the same";
	off.center_in_map.x() -= 0.3;
	other.lookAtDoors({off}, 6);
	ASSERT_EQ(other.tracks.tracks.size(), 1U);
	EXPECT_EQ(other.tracks.tracks[0].number, 1);
}

TEST(DoorTracks, APoseCorrectionMovesThemAll)
{
	const std::vector<KnownDoor> doors{kDoor, {{2.5, 1.1}, 240 * kDegree_rad}};
	Scout scout;
	scout.lookAtDoors(doors, 6);
	const DoorTracks before = scout.tracks;
	scout.moved = robotAt(0.4, -0.3, 10 * kDegree_rad);  // 0.5 m and 10°
	correct(scout.tracks, scout.moved);
	for (std::size_t i = 0; i < doors.size(); ++i)
	{
		const DoorTrack &now = scout.tracks.tracks.at(i), &then = before.tracks.at(i);
		const Eigen::Vector3d center =
		    scout.moved * Eigen::Vector3d(then.place.center_in_map.x(), then.place.center_in_map.y(), 0);
		EXPECT_LT((now.place.center_in_map - center.head<2>()).norm(), 1e-9);
		EXPECT_NEAR(wrapToPi(now.place.normal_rad - then.place.normal_rad), 10 * kDegree_rad, 1e-9);
		EXPECT_NEAR(now.center_covariance.determinant(), then.center_covariance.determinant(), 1e-12);
	}
	std::vector<Door> reports;
	++scout.step;
	scout.t_s += 0.5;
	for (const KnownDoor& door : doors)
		reports.push_back(reportOf(door, robotAt(0, scout.step % 2 == 0 ? 0.15 : -0.15, 0)));
	EXPECT_EQ(scout.look(reports), (std::vector<int>{1, 2})) << "the next look finds them where they are";
	EXPECT_EQ(scout.tracks.tracks.size(), 2U);
	EXPECT_FALSE(scout.tracks.tracks[0].visited) << "the jump was no way through a door";
}

TEST(DoorTracks, ADoorThatTheRobotWentThroughIsVisited)
{
	Scout scout;
	scout.lookAtDoors({kDoor, {{3, 2}, std::numbers::pi}}, 3);
	for (int i = 0; i < 40; ++i)
		update(scout.tracks, lookAt({}, robotAt(0.1 * i, 0.1, std::numbers::pi), 10 + 0.1 * i), kRobot, kConfig);
	EXPECT_TRUE(scout.tracks.tracks.at(0).visited);
	EXPECT_FALSE(scout.tracks.tracks.at(1).visited);
}

TEST(DoorTracks, WhatTheRobotWentThroughIsOpenWhateverItLookedLikeFromAfar)
{
	Scout scout;
	scout.lookAtDoors({with(kDoor, Verdict::unknown)}, 12);
	ASSERT_TRUE(scout.tracks.tracks.at(0).existence.confirmed);
	EXPECT_EQ(verdictOf(scout.tracks.tracks[0]), Verdict::unknown);
	for (int i = 0; i < 40; ++i)
		update(scout.tracks, lookAt({}, robotAt(0.1 * i, 0.1, std::numbers::pi), 10 + 0.1 * i), kRobot, kConfig);
	const DoorTrack& track = scout.tracks.tracks.at(0);
	EXPECT_TRUE(track.visited);
	EXPECT_EQ(verdictOf(track), Verdict::open);
	EXPECT_GT(confidenceOf(track), 0.5);
	EXPECT_GE(clearWidthOf(track.belief), 2 * kRobot.radius_m);
}

TEST(DoorTracks, NothingToSeeBehindIsAWeakSignOfADoor)
{
	Scout shut, dark;
	shut.lookAtDoors({with(kDoor, Verdict::closed)}, 4);
	dark.lookAtDoors({with(kDoor, Verdict::unknown)}, 4);
	EXPECT_TRUE(shut.tracks.tracks.at(0).existence.confirmed);
	EXPECT_FALSE(dark.tracks.tracks.at(0).existence.confirmed) << "walls at grazing angles look like that";
	dark.lookAtDoors({with(kDoor, Verdict::unknown)}, 20);
	EXPECT_TRUE(dark.tracks.tracks.at(0).existence.confirmed) << "panes of glass as well";
}

TEST(DoorTracks, TheMapObjectsToAMirror)
{
	// What stands 2 m in front of the wall at x = 3 stands 2 m behind it, too; corridor walls would not tell.
	const OccupancyQuery mirror = [](const Eigen::Vector3d& point)
	{
		const double away_m = std::abs(point.x() - 3);
		return away_m > 1.9 && away_m < 2.1 ? VoxelState::occupied : VoxelState::free;
	};
	Scout scout;
	for (int i = 0; i < 6; ++i)
	{
		++scout.step;
		scout.t_s += 0.5;
		const std::vector<Door> reports{reportOf(kDoor, scout.where())};
		DoorLook look = lookAt(reports, scout.where(), scout.t_s);
		look.occupancy = mirror;
		update(scout.tracks, look, kRobot, kConfig);
		for (const Door& door : confirmedDoors(scout.tracks, Eigen::Isometry3d::Identity()))
		{
			EXPECT_FALSE(isPassable(door.verdict));
			EXPECT_LT(*door.confidence, 0.5);
		}
	}
}

TEST(DoorTracks, WhatTheMapObjectedToIsPassableAgainWhenItIsGone)
{
	bool someone_there = true;
	Scout scout;
	const auto step_with = [&](const std::vector<Door>& reports)
	{
		scout.t_s += 0.5;
		DoorLook look = lookAt(reports, scout.where(), scout.t_s);
		look.occupancy = [&](const Eigen::Vector3d&)
		{ return someone_there ? VoxelState::occupied : VoxelState::free; };
		update(scout.tracks, look, kRobot, kConfig);
	};
	for (int i = 0; i < 5; ++i, ++scout.step) step_with({reportOf(kDoor, scout.where())});
	ASSERT_EQ(verdictOf(scout.tracks.tracks.at(0)), Verdict::blocked);
	someone_there = false;
	step_with({});  // no look at the door itself
	EXPECT_EQ(verdictOf(scout.tracks.tracks.at(0)), Verdict::open);
}

TEST(DoorTracks, AnOpeningInAWallWithoutThicknessIsAMirrorUntilTheRobotWentThrough)
{
	Scout scout;
	const auto look_with = [&](const RevealRows& rows)
	{
		++scout.step;
		scout.t_s += 0.5;
		const std::vector<Door> reports{reportOf(kDoor, scout.where())};
		DoorLook look = lookAt(reports, scout.where(), scout.t_s);
		look.reveal = [rows](const DoorPlace&) { return rows; };
		update(scout.tracks, look, kRobot, kConfig);
	};
	for (int i = 0; i < 5; ++i) look_with({.flat = 10, .thick = 1});
	ASSERT_TRUE(scout.tracks.tracks.at(0).existence.confirmed);
	EXPECT_EQ(verdictOf(scout.tracks.tracks[0]), Verdict::unknown);
	scout.tracks.tracks[0].visited = true;
	look_with({.flat = 10, .thick = 1});
	EXPECT_EQ(verdictOf(scout.tracks.tracks[0]), Verdict::open);

	scout = {};
	for (int i = 0; i < 5; ++i) look_with({.flat = 5, .thick = 5});
	EXPECT_EQ(verdictOf(scout.tracks.tracks.at(0)), Verdict::open);
}

TEST(DoorTracks, StairsThatWereSeenAreNotForgottenWhereTheFloorIsOutOfView)
{
	Scout scout;
	scout.lookAtDoors({with(kDoor, Verdict::drop)}, 2);
	scout.lookAtDoors({kDoor}, 20);
	ASSERT_TRUE(scout.tracks.tracks.at(0).existence.confirmed);
	EXPECT_EQ(verdictOf(scout.tracks.tracks[0]), Verdict::drop);
	EXPECT_LT(confidenceOf(scout.tracks.tracks[0]), 0.5);

	const auto look_with_floor = [&]
	{
		++scout.step;
		scout.t_s += 0.5;
		Door report = reportOf(kDoor, scout.where());
		report.evidence.emplace().floor_beyond = 1.0;
		scout.look({report});
	};
	for (int i = 0; i < 3; ++i) look_with_floor();
	EXPECT_EQ(verdictOf(scout.tracks.tracks.at(0)), Verdict::open) << "more looks saw the floor than missed it";
}

TEST(DoorTracks, ACounterStopsARobotOnTheGroundAndNotOneThatFlies)
{
	const OccupancyQuery counter = [](const Eigen::Vector3d& point)
	{ return std::abs(point.x() - 3) < 0.2 && point.z() < 1.0 ? VoxelState::occupied : VoxelState::free; };
	RobotConfig flying;
	flying.kind = RobotKind::mav;
	flying.radius_m = 0.3;
	flying.height_m = 0.25;
	for (const RobotConfig& robot : {kRobot, flying})
	{
		const bool flies = robot.kind == RobotKind::mav;
		DoorTracks tracks;
		for (int i = 0; i < 5; ++i)
		{
			// Rolling and pitching at 1.4 m, as it accelerates.
			Eigen::Isometry3d map_from_robot = robotAt(0.1 * i, 0.1 * (i % 2), 0);
			if (flies)
			{
				map_from_robot.translation().z() = 1.4;
				map_from_robot.rotate(Eigen::AngleAxisd(8 * kDegree_rad * (i - 2), Eigen::Vector3d(0.6, 0.8, 0)));
			}
			const std::vector<Door> reports{reportOf(kDoor, map_from_robot)};
			DoorLook look = lookAt(reports, map_from_robot, 0.5 * i);
			look.occupancy = counter;
			update(tracks, look, robot, kConfig);
		}
		ASSERT_EQ(tracks.tracks.size(), 1U);
		EXPECT_TRUE(tracks.tracks[0].existence.confirmed);
		EXPECT_NEAR(tracks.tracks[0].place.floor_m, 0, 1e-6);
		EXPECT_LT((tracks.tracks[0].place.center_in_map - kDoor.center_in_map).norm(), 1e-6);
		EXPECT_EQ(verdictOf(tracks.tracks[0]), flies ? Verdict::open : Verdict::blocked);
	}
}

TEST(DoorTracks, MemoryIsBoundedAndTheLeastSureGoFirst)
{
	DoorTrackConfig small;
	small.max_tracks = 5;
	Scout scout;
	scout.lookAtDoors({kDoor}, 4);
	for (int i = 0; i < 50; ++i)
	{
		const std::vector<Door> reports{reportOf({{3, 2.0 + 3 * i}, std::numbers::pi}, scout.where())};
		DoorLook look = lookAt(reports, scout.where(), scout.t_s + i * 0.5);
		look.view = {};
		update(scout.tracks, look, kRobot, small);
		ASSERT_LE(scout.tracks.tracks.size(), 5U);
	}
	EXPECT_EQ(scout.tracks.tracks.at(0).number, 1);
}
}  // namespace
}  // namespace explore::test
