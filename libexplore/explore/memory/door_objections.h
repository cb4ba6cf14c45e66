// What speaks against passing a door that looks open: a wall without thickness, no floor, what the map holds in it.
#pragma once

#include <explore/memory/door_tracks.h>

namespace explore
{
/** Asks the frame and the map about every track that this frame looked at, and the map about near ones that it objected
 *  to before. */
void objectToTracks(DoorTracks& tracks, const DoorLook& look, const RobotConfig& robot, const DoorTrackConfig& config);
}  // namespace explore
