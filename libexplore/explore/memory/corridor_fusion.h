// Which vanishing points belong to which corridor, and the mean of those that belong together.
#pragma once

#include <explore/memory/corridor_tracks.h>

#include <optional>

namespace explore
{
/** Squared Mahalanobis distance in offset and direction, at the sighting's point. No value beyond the gate, or where
 * the two pieces of the axis are too far apart. */
std::optional<double> distanceOf(const CorridorTrack& track, const CorridorSighting& sighting,
                                 const CorridorTrackConfig& config);

/** Moves the track by weighted mean, its point to the one of the sighting, and its ends as far as was seen. */
void fuse(CorridorTrack& track, const CorridorSighting& sighting);

CorridorTrack newCorridor(int number, const CorridorSighting& sighting);
CorridorSighting asSighting(const CorridorTrack& track);
/** Both as one, with the number of `a`. */
CorridorTrack joined(const CorridorTrack& a, const CorridorTrack& b);
}  // namespace explore
