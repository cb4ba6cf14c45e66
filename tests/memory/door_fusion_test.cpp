#include <explore/core/geometry.h>
#include <explore/memory/door_fusion.h>
#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>

#include "door_looks.h"

namespace explore::test
{
namespace
{
const Eigen::Vector3d kCamera(0, 0, 0.5);

DoorSighting sightingOf(const KnownDoor& door, const Eigen::Isometry3d& map_from_robot = robotAt(0, 0, 0))
{
	return explore::sightingOf(reportOf(door, map_from_robot), map_from_robot,
	                           map_from_robot * Eigen::Vector3d(0, 0, 0.5), {});
}

DoorTrack trackOf(int number, const DoorSighting& sighting)
{
	DoorTrack track;
	track.number = number;
	track.place = sighting.place;
	track.center_covariance = sighting.center_covariance;
	track.normal_variance = sighting.normal_variance;
	track.width_variance = sighting.width_variance;
	return track;
}

KnownDoor randomDoor(Dice& dice)
{
	const double x_m = dice.uniform(1, 5), y_m = dice.uniform(-2, 2);
	return {{x_m, y_m}, dice.uniform(-3, 3), dice.uniform(0.7, 1.4)};
}

using Costs = std::vector<std::vector<std::optional<double>>>;

/** The least sum, over all ways to pair tracks with sightings, of what each pair costs less than being left alone. */
double leastCost(const Costs& costs, std::size_t track, std::vector<bool>& taken, double gate)
{
	if (track == costs.size()) return 0;
	double least = leastCost(costs, track + 1, taken, gate);
	for (std::size_t j = 0; j < taken.size(); ++j)
	{
		if (taken[j] || !costs[track][j]) continue;
		taken[j] = true;
		least = std::min(least, *costs[track][j] - gate + leastCost(costs, track + 1, taken, gate));
		taken[j] = false;
	}
	return least;
}

TEST(DoorFusion, AssociationIsTheBestOfAllPairings)
{
	Dice dice(3);
	const DoorFusionConfig config;
	int pairs_made = 0;
	for (int round = 0; round < 400; ++round)
	{
		std::vector<DoorTrack> tracks;
		std::vector<DoorSighting> sightings;
		const int doors = static_cast<int>(dice.uniform(1, 5));
		for (int i = 0; i < doors; ++i)
		{
			KnownDoor door = randomDoor(dice);
			if (dice.chance(0.8)) tracks.push_back(trackOf(i + 1, sightingOf(door)));
			door.center_in_map += Eigen::Vector2d(dice.gauss(), dice.gauss()) * dice.uniform(0.02, 0.25);
			if (dice.chance(0.8)) sightings.push_back(sightingOf(door));
		}
		Costs costs(tracks.size(), std::vector<std::optional<double>>(sightings.size()));
		for (std::size_t i = 0; i < tracks.size(); ++i)
			for (std::size_t j = 0; j < sightings.size(); ++j)
				costs[i][j] = distanceOf(tracks[i], sightings[j], 0, config);
		const auto pairs = associate(tracks, sightings, 0, config);
		ASSERT_EQ(pairs.size(), tracks.size());
		double cost = 0;
		for (std::size_t i = 0; i < pairs.size(); ++i)
		{
			if (!pairs[i]) continue;
			cost += *costs[i][*pairs[i]] - config.gate;
			++pairs_made;
		}
		std::vector<bool> taken(sightings.size(), false);
		EXPECT_NEAR(cost, leastCost(costs, 0, taken, config.gate), 1e-9) << "round " << round;
	}
	EXPECT_GT(pairs_made, 300);
}

TEST(DoorFusion, AReportOfAnotherWallIsNotTheSameDoor)
{
	const KnownDoor door{{3, 0}, std::numbers::pi};
	const DoorTrack track = trackOf(1, sightingOf(door));
	KnownDoor across = door;
	across.normal_rad += 60 * kDegree_rad;
	EXPECT_FALSE(distanceOf(track, sightingOf(across), 0, {}));
	KnownDoor behind = door;
	behind.normal_rad = 0;
	EXPECT_TRUE(distanceOf(track, sightingOf(behind), 0, {})) << "the same wall from its other side";
	KnownDoor beside = door;
	beside.center_in_map.y() += 1.0;
	EXPECT_FALSE(distanceOf(track, sightingOf(beside), 0, {}));
	EXPECT_TRUE(distanceOf(track, sightingOf(door), 0, {}));
}

TEST(DoorFusion, AReportThatCoversTheTrackBelongsToItHoweverFarItsMiddleIs)
{
	DoorTrack track = trackOf(1, sightingOf({{2, 0}, std::numbers::pi, 1.2}));
	track.center_covariance *= 1e-4;
	const auto distance = distanceOf(track, sightingOf({{2, 0.35}, std::numbers::pi, 0.6}), 0, {});
	ASSERT_TRUE(distance);
	EXPECT_LT(*distance, DoorFusionConfig().gate);
}

TEST(DoorFusion, AWanderingPoseMakesATrackLessSure)
{
	const KnownDoor door{{3, 0}, std::numbers::pi};
	KnownDoor seen_later = door;
	seen_later.center_in_map.x() += 0.5;
	const DoorTrack track = trackOf(1, sightingOf(door));
	EXPECT_TRUE(distanceOf(track, sightingOf(seen_later), 100, {})) << "after 100 m";
}

TEST(DoorFusion, FusedLooksAreTheirInformationWeightedMean)
{
	Dice dice(4);
	for (int round = 0; round < 50; ++round)
	{
		const KnownDoor door = randomDoor(dice);
		std::vector<DoorSighting> looks;
		Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
		Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
		double width_information = 0, weighted_width = 0;
		for (int i = 0; i < 8; ++i)
		{
			const auto map_from_robot = robotAt(dice.uniform(-1, 0.5), dice.uniform(-1, 1), dice.uniform(-0.3, 0.3));
			DoorSighting look = sightingOf(door, map_from_robot);
			const Eigen::LLT<Eigen::Matrix2d> root(look.center_covariance);
			look.place.center_in_map += root.matrixL() * Eigen::Vector2d(0.6 * dice.gauss(), 0.6 * dice.gauss());
			look.place.width_m += 0.6 * std::sqrt(look.width_variance) * dice.gauss();
			looks.push_back(look);
			information += look.center_covariance.inverse();
			weighted += look.center_covariance.inverse() * look.place.center_in_map;
			width_information += 1 / look.width_variance;
			weighted_width += look.place.width_m / look.width_variance;
		}
		DoorTrack track = trackOf(1, looks[0]);
		for (std::size_t i = 1; i < looks.size(); ++i) fuse(track, looks[i], 0, {});
		const Eigen::Vector2d mean = information.inverse() * weighted;
		EXPECT_LT((track.place.center_in_map - mean).norm(), 0.006) << "round " << round;
		EXPECT_NEAR(track.place.width_m, weighted_width / width_information, 0.006);
		EXPECT_NEAR(track.center_covariance.trace(), information.inverse().trace(),
		            0.5 * information.inverse().trace());
	}
}

TEST(DoorFusion, TheNormalMayPointEitherWay)
{
	const KnownDoor door{{3, 0}, std::numbers::pi - 0.05};
	DoorTrack track = trackOf(1, sightingOf(door));
	DoorSighting look = sightingOf(door);
	look.place.normal_rad = 0.05;  // that is π + 0.05 for the same wall
	fuse(track, look, 0, {});
	EXPECT_NEAR(std::abs(track.place.normal_rad), std::numbers::pi, 0.01);
}

TEST(DoorFusion, DoorsThatWereSeenSideBySideAreTwo)
{
	DoorTrack a = trackOf(1, sightingOf({{3, 0.2}, std::numbers::pi, 0.9}));
	DoorTrack b = trackOf(2, sightingOf({{3, -0.1}, std::numbers::pi, 0.9}));
	EXPECT_TRUE(areOneDoor(a, b, {}));
	b.seen_beside = {1};
	EXPECT_FALSE(areOneDoor(a, b, {}));
	EXPECT_FALSE(areOneDoor(b, a, {}));
}

TEST(DoorFusion, DoorsOfWallsAcrossACornerAreTwo)
{
	const DoorTrack a = trackOf(1, sightingOf({{3, 0}, std::numbers::pi, 0.9}));
	const DoorTrack b = trackOf(2, sightingOf({{2.45, 0.55}, -std::numbers::pi / 2, 0.9}));
	EXPECT_FALSE(areOneDoor(a, b, {}));
}

TEST(DoorFusion, JoinedTracksKeepTheFirstNumberAndAllThatWasLearned)
{
	DoorTrack a = trackOf(4, sightingOf({{3, 0}, std::numbers::pi, 0.9}));
	DoorTrack b = trackOf(9, sightingOf({{3, 0.1}, std::numbers::pi, 0.9}));
	b.existence.log_odds = 3;
	b.existence.confirmed = true;
	b.visited = true;
	const DoorTrack joined_track = joined(a, b, {});
	EXPECT_EQ(joined_track.number, 4);
	EXPECT_TRUE(joined_track.existence.confirmed);
	EXPECT_TRUE(joined_track.visited);
	EXPECT_NEAR(joined_track.place.center_in_map.y(), 0.05, 0.01);
}

TEST(DoorFusion, FarAndGrazingReportsAreLessSure)
{
	const auto near = sightingOf({{1.5, 0}, std::numbers::pi}), far = sightingOf({{4.5, 0}, std::numbers::pi});
	const auto grazing = sightingOf({{1.5, 0}, std::numbers::pi + 65 * kDegree_rad});
	EXPECT_GT(far.center_covariance.trace(), 1.3 * near.center_covariance.trace());
	EXPECT_LT(far.quality, 0.6 * near.quality);
	EXPECT_LT(grazing.quality, 0.6 * near.quality);
	EXPECT_NEAR(grazing.incidence_rad, 65 * kDegree_rad, 1e-9);
	EXPECT_GT(near.quality, 0.8);
}
}  // namespace
}  // namespace explore::test
