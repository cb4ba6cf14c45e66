// The true doors of a frame as marks in its picture.
#pragma once

#include <explore/evaluation/worst_frames.h>
#include <explore/sinks/picture_style.h>

namespace explore::evaluation
{
/** Turquoise: has to be found; violet: counts neither way; grey: hidden, or not to be passed. Those further than
 *  `max_range_m` + 1 m from the robot are left out. */
std::vector<DoorMark> truthMarks(const TruthFrame& truth, double max_range_m);
}  // namespace explore::evaluation
