// Doors remembered over whole drives, from noisy reports of doors whose places are known.
#include <explore/core/geometry.h>
#include <explore/memory/door_tracks.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "door_looks.h"

namespace explore::test
{
namespace
{
const RobotConfig kRobot;
const DoorTrackConfig kConfig;

/** A drive along a corridor with doors on both sides, the camera turning this way and that. */
struct Drive
{
	static constexpr int kFrames = 600;
	static Eigen::Isometry3d at(int frame)
	{
		return robotAt(0.04 * frame, 0.2 * std::sin(0.03 * frame), 45 * kDegree_rad * std::sin(0.05 * frame));
	}
};

std::vector<KnownDoor> corridorDoors(Dice& dice)
{
	std::vector<KnownDoor> doors;
	for (int i = 0; i < 16; ++i)
	{
		const double x_m = 2 + 1.4 * i + dice.uniform(-0.15, 0.15), side = i % 2 == 0 ? 1 : -1;
		const bool shut = i % 5 == 4;
		doors.push_back({{x_m, 1.2 * side},
		                 -side * 90 * kDegree_rad,
		                 dice.uniform(0.75, 1.1),
		                 shut ? Verdict::closed : Verdict::open});
	}
	return doors;
}

/** Reports as a detector that is right most of the time would make them. */
std::vector<Door> frameOf(const std::vector<KnownDoor>& doors, const Eigen::Isometry3d& map_from_robot, Dice& dice)
{
	std::vector<Door> reports;
	for (const KnownDoor& door : doors)
	{
		if (!isInView(placeOf(door), map_from_robot) || !dice.chance(0.93)) continue;
		Door report = noisyReport(door, map_from_robot, dice);
		if (dice.chance(0.04))
		{
			report.verdict = isPassable(door.verdict) ? Verdict::blocked : Verdict::open;
			report.confidence = isPassable(door.verdict) ? 0.3 : 0.6;
		}
		reports.push_back(report);
	}
	if (dice.chance(0.03))
	{
		const KnownDoor nothing{{map_from_robot.translation().x() + dice.uniform(1, 4), dice.uniform(-1.2, 1.2)},
		                        dice.uniform(-3, 3)};
		Door report = noisyReport(nothing, map_from_robot, dice);
		report.confidence = dice.uniform(0.5, 0.95);
		reports.push_back(report);
	}
	return reports;
}

struct Score
{
	int due = 0, found = 0;       ///< open doors that were looked at five times; of those confirmed by then
	int passable = 0, right = 0;  ///< confirmed tracks that can be passed, in all frames; at an open door
	int doubles = 0;              ///< tracks beyond the first at one door, in the last frame
	double error_m = 0;           ///< largest distance of a track from its door in the last frame
};

bool isAt(const DoorTrack& track, const KnownDoor& door)
{
	return (track.place.center_in_map - door.center_in_map).norm() < 0.3 &&
	       std::abs(track.place.width_m - door.width_m) < 0.25;
}

bool isPassableTrack(const DoorTrack& track)
{
	return track.existence.confirmed && isPassable(verdictOf(track));
}

void scoreFrame(const DoorTracks& tracks, const std::vector<KnownDoor>& doors, Score& score)
{
	for (const DoorTrack& track : tracks.tracks)
	{
		if (!isPassableTrack(track)) continue;
		++score.passable;
		score.right += std::ranges::any_of(
		                   doors, [&](const KnownDoor& door) { return isPassable(door.verdict) && isAt(track, door); })
		                   ? 1
		                   : 0;
	}
}

void scoreEnd(const DoorTracks& tracks, const std::vector<KnownDoor>& doors, Score& score)
{
	for (const KnownDoor& door : doors)
	{
		int near = 0;
		for (const DoorTrack& track : tracks.tracks)
		{
			const double distance_m = (track.place.center_in_map - door.center_in_map).norm();
			if (!track.existence.confirmed || distance_m > 0.5) continue;
			++near;
			score.error_m = std::max(score.error_m, distance_m);
		}
		score.doubles += std::max(0, near - 1);
	}
}

Score scoreOf(std::uint32_t seed)
{
	Dice dice(seed);
	const std::vector<KnownDoor> doors = corridorDoors(dice);
	std::vector<int> looks(doors.size(), 0);
	DoorTracks tracks;
	Score score;
	for (int frame = 0; frame < Drive::kFrames; ++frame)
	{
		const Eigen::Isometry3d map_from_robot = Drive::at(frame);
		const std::vector<Door> reports = frameOf(doors, map_from_robot, dice);
		update(tracks, lookAt(reports, map_from_robot, 0.2 * frame), kRobot, kConfig);
		scoreFrame(tracks, doors, score);
		for (std::size_t i = 0; i < doors.size(); ++i)
		{
			if (!isPassable(doors[i].verdict) || !isInView(placeOf(doors[i]), map_from_robot) || ++looks[i] != 5)
				continue;
			++score.due;
			score.found += std::ranges::any_of(tracks.tracks, [&](const DoorTrack& track)
			                                   { return isPassableTrack(track) && isAt(track, doors[i]); })
			                   ? 1
			                   : 0;
		}
	}
	scoreEnd(tracks, doors, score);
	return score;
}

TEST(DoorTracks, ADriveAlongNoisyReportsEndsWithTheTrueDoors)
{
	Score all;
	constexpr std::uint32_t kSeeds = 20;
	for (std::uint32_t seed = 1; seed <= kSeeds; ++seed)
	{
		const Score score = scoreOf(seed);
		all.due += score.due;
		all.found += score.found;
		all.passable += score.passable;
		all.right += score.right;
		all.doubles += score.doubles;
		all.error_m = std::max(all.error_m, score.error_m);
	}
	EXPECT_GE(all.due, 200);
	RecordProperty("recall", std::to_string(all.found) + "/" + std::to_string(all.due));
	RecordProperty("precision", std::to_string(all.right) + "/" + std::to_string(all.passable));
	EXPECT_GE(all.found, 0.99 * all.due) << all.found << " of " << all.due;
	EXPECT_GE(all.right, 0.998 * all.passable) << all.right << " of " << all.passable;
	EXPECT_EQ(all.doubles, 0);
	EXPECT_LT(all.error_m, 0.1);
}

TEST(DoorTracks, TheSameLooksMakeTheSameTracks)
{
	const auto run = []
	{
		Dice dice(5);
		const std::vector<KnownDoor> doors = corridorDoors(dice);
		DoorTracks tracks;
		std::vector<double> numbers;
		for (int frame = 0; frame < 200; ++frame)
		{
			const auto reports = frameOf(doors, Drive::at(frame), dice);
			for (const int number : update(tracks, lookAt(reports, Drive::at(frame), 0.2 * frame), kRobot, kConfig))
				numbers.push_back(number);
		}
		for (const DoorTrack& track : tracks.tracks)
			numbers.insert(numbers.end(),
			               {track.place.center_in_map.x(), track.place.width_m, track.existence.log_odds});
		return numbers;
	};
	EXPECT_EQ(run(), run());
}

TEST(DoorTracks, EveryReportHasATrackThatExists)
{
	Dice dice(9);
	const std::vector<KnownDoor> doors = corridorDoors(dice);
	DoorTracks tracks;
	for (int frame = 0; frame < 300; ++frame)
	{
		const auto reports = frameOf(doors, Drive::at(frame), dice);
		const auto numbers = update(tracks, lookAt(reports, Drive::at(frame), 0.2 * frame), kRobot, kConfig);
		ASSERT_EQ(numbers.size(), reports.size());
		for (const int number : numbers)
			EXPECT_EQ(std::ranges::count(tracks.tracks, number, &DoorTrack::number), 1) << "frame " << frame;
		EXPECT_TRUE(std::ranges::is_sorted(tracks.tracks, {}, &DoorTrack::number));
	}
}
}  // namespace
}  // namespace explore::test
