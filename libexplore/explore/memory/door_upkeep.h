// What happens to door tracks after a look: joined where two are one, forgotten where they are none.
#pragma once

#include <explore/memory/door_tracks.h>

#include <vector>

namespace explore
{
/** Where the number of a track that is no more went. */
struct JoinedTrack
{
	int number = 0, into = 0;
};

/** Joins tracks that are one door, until none are; in the order in which it was done. */
std::vector<JoinedTrack> joinDoubles(DoorTracks& tracks, const DoorFusionConfig& config);

/** Forgets tracks that are most likely not there, unconfirmed ones that were not reported for long, and the least sure
 *  beyond the bound. */
void forget(DoorTracks& tracks, double now_s, const DoorTrackConfig& config);

/** The reports of one frame that lie side by side are of different doors, and their tracks will not be joined. Of each
 *  track the latest few such are kept. */
void noteSeenBeside(DoorTracks& tracks, const std::vector<DoorSighting>& sightings,
                    const std::vector<int>& number_of_sighting, const DoorFusionConfig& config);
}  // namespace explore
