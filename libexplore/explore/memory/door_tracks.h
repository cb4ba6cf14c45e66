// The memory of doors: each frame's reports become tracks in the map that are confirmed, moved, joined and forgotten.
#pragma once

#include <explore/memory/door_fusion.h>
#include <explore/memory/door_map_check.h>
#include <explore/memory/door_sight.h>

#include <optional>
#include <span>
#include <vector>

namespace explore
{
struct DoorTrackConfig
{
	SightingNoiseConfig noise;
	DoorFusionConfig fusion;
	ExistenceConfig existence;
	MapCheckConfig map_check;
	double fading = 0.8;              ///< what remains of a verdict's weight after another look of full weight
	double detect_probability = 0.8;  ///< of a door in plain view, near and frontal
	double through_doubt = 0.5;       ///< how much less a miss tells where rays go through the opening
	/** An opening is a mirror when the wall beside it had no inner face in so many rows of pixels, and in so many of
	 *  those that tell. */
	int flat_rows = 8;
	double flat_share = 0.6;
	double forget_s = 60, forget_m = 5;  ///< an unconfirmed track is kept for so long, or so much way, without a report
	int max_tracks = 500;                ///< beyond, the least sure are forgotten
};
/** [door_tracks] */
void describe(FieldVisitor& fields, DoorTrackConfig& config);

/** What one frame has to say about doors. */
struct DoorLook
{
	std::span<const Door> doors_in_robot;
	Eigen::Isometry3d map_from_robot = Eigen::Isometry3d::Identity();
	Eigen::Isometry3d robot_from_camera = Eigen::Isometry3d::Identity();
	double t_s = 0;            ///< mrpt::Clock::toDouble
	DoorQuery view;            ///< none: nothing is held against a track that no report came of
	RevealQuery reveal;        ///< none: walls are not asked for their thickness
	OccupancyQuery occupancy;  ///< none: the map is not asked for objections
};

/** Adds one frame; times must not go back. Returns the track of each of its doors: of a report, also of one that is too
 *  soon after the last look to count, there always is one. Same looks, same tracks. */
std::vector<int> update(DoorTracks& tracks, const DoorLook& look, const RobotConfig& robot,
                        const DoorTrackConfig& config);

/** Moves all that is remembered into a map whose poses were corrected: new_map_from_map takes what was said before to
 *  where it is now. */
void correct(DoorTracks& tracks, const Eigen::Isometry3d& new_map_from_map);
}  // namespace explore
