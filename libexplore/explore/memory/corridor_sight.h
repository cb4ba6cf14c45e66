// How far a depth frame shows free way ahead: whether a corridor should have been seen in it.
#pragma once

#include <explore/core/depth_frame.h>

namespace explore
{
/** Median depth [m] of the pixels in the middle tenth of the image, each way; 0 where most of them have no return, or
 *  without an image. */
double clearAhead(const DepthFrame& frame);
}  // namespace explore
