// The far jamb of an opening that is seen from the side.
#pragma once

#include <explore/perception/opening_evidence.h>

#include <vector>

namespace explore
{
/** The middle value; reorders them. 0 of none. */
double medianOf(std::vector<float>& values);

/** Seen from the side, rays that enter an opening end on the face of its far jamb, and those near the edge end there so
 *  little behind the wall that they count as wall: the opening seems narrower than it is. The face itself tells where
 *  the jamb is: all points on it have the jamb's along_m. Returns the frame with the far jamb put there, where a face
 *  is seen and nothing else. */
OpeningFrame withFarJambFromFace(const RayJudge& judge, const OpeningFrame& frame, const BodyBand& body);
}  // namespace explore
