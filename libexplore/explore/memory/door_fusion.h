// Which reports belong to which tracks, and the mean of all that belong together.
#pragma once

#include <explore/memory/door_sighting.h>
#include <explore/memory/door_track.h>

#include <optional>
#include <vector>

namespace explore
{
struct DoorFusionConfig
{
	double gate = 16.3;  ///< of the squared Mahalanobis distance: 99.9 % with three degrees of freedom
	double max_angle_rad = 0.785398163397448;  ///< 45°: walls of one door's reports
	double drift_m = 0.02;                     ///< standard deviation of the robot's pose after 1 m, growing with √m
	double shared_error_m = 0.03;              ///< what looks at one door have in common, and never gets better
	double shared_error_rad = 0.02;
	double width_spread_m = 0.3;    ///< of widths of one door's reports, for telling doors apart
	double merge_overlap = 0.5;     ///< of the narrower opening: tracks that share more are one door
	double merge_across_m = 0.4;    ///< and whose walls are not farther from each other
	double merge_distance_m = 0.3;  ///< tracks whose middles are nearer are one door, whatever their walls
};
/** Field list of the above; without a section of its own. */
void describe(FieldVisitor& fields, DoorFusionConfig& config);

/** Squared Mahalanobis distance of `sighting` from `track`: middle, wall direction, and width as far as it tells doors
 *  apart. No value where the walls are too far apart in direction, or beyond the gate. Openings that mostly cover each
 *  other belong together even beyond the gate, as the last choice. */
std::optional<double> distanceOf(const DoorTrack& track, const DoorSighting& sighting, double travelled_m,
                                 const DoorFusionConfig& config);

/** The sighting of each track, or no value: the pairs with the least sum of distances, a track or a sighting left alone
 *  costing as much as the gate. */
std::vector<std::optional<std::size_t>> associate(const std::vector<DoorTrack>& tracks,
                                                  const std::vector<DoorSighting>& sightings, double travelled_m,
                                                  const DoorFusionConfig& config);

/** Moves the track's place by information-weighted mean; `travelled_m` since the last look has made it less sure. */
void fuse(DoorTrack& track, const DoorSighting& sighting, double travelled_m, const DoorFusionConfig& config);

/** Whether both places are about one opening: they mostly cover each other, or their middles are very near. */
bool areOnePlace(const DoorPlace& a, const DoorPlace& b, const DoorFusionConfig& config);
/** Whether two tracks are about one door: no frame showed them side by side, and they cover each other. */
bool areOneDoor(const DoorTrack& a, const DoorTrack& b, const DoorFusionConfig& config);
/** Both as one, with the number of the one that was first. */
DoorTrack joined(const DoorTrack& a, const DoorTrack& b, const DoorFusionConfig& config);
}  // namespace explore
