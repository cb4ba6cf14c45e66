// One door as all looks together have it.
#pragma once

#include <explore/memory/door_belief.h>
#include <explore/memory/door_place.h>
#include <explore/memory/door_reveal.h>
#include <explore/memory/track_existence.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace explore
{
struct DoorTrack
{
	int number = 0;  ///< from 1, never used again
	DoorPlace place;
	Eigen::Matrix2d center_covariance = Eigen::Matrix2d::Identity();  ///< [m²], map axes
	double normal_variance = 0, width_variance = 0;                   ///< rad², m²
	double fused_at_m = 0;  ///< DoorTracks::travelled_m when a look was last fused

	Existence existence;
	DoorBelief belief;
	RevealRows reveal;  ///< of all looks, faded
	/** Weights of the looks that saw a floor behind the opening, and that saw that there is none. */
	double floor_seen = 0, floor_missing = 0;
	/** What speaks against passing here although most looks say otherwise: drop (those that had the floor behind in
	 *  view; from nearby it is out of view), blocked (the map, seen from elsewhere, holds something in
	 *  the way) or unknown (a mirror: what is behind is the mirror image of what is in front, or the wall has no
	 *  thickness). */
	std::optional<Verdict> objection;
	bool visited = false;  ///< the robot went through

	/** Numbers of tracks that some frame showed beside this one: they are not the same door, however near. */
	std::vector<int> seen_beside;
};

/** All that the memory of doors carries from frame to frame. */
struct DoorTracks
{
	std::vector<DoorTrack> tracks;  ///< by number
	int next_number = 1;
	double travelled_m = 0;                       ///< by the robot, on the plan
	std::optional<Eigen::Vector2d> robot_in_map;  ///< in the last frame
};

/** The verdict of the looks, unless the map objects to passing. */
[[nodiscard]] Verdict verdictOf(const DoorTrack& track);
/** P(the robot can pass), below a half where the map objects. */
[[nodiscard]] double confidenceOf(const DoorTrack& track);

/** As a report in the robot frame, its normal toward the robot: what goals and headings are chosen from. */
[[nodiscard]] Door doorOf(const DoorTrack& track, const Eigen::Isometry3d& robot_from_map);
/** Those of all confirmed tracks, by number. */
[[nodiscard]] std::vector<Door> confirmedDoors(const DoorTracks& tracks, const Eigen::Isometry3d& robot_from_map);
}  // namespace explore
