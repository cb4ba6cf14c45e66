// Whether any of the rays through a part of the image crosses a voxel and ends behind it.
#pragma once

#include <explore/memory/frame_rays.h>
#include <explore/memory/reach_pyramid.h>

namespace explore
{
/** Whether a ray of the pixels in `rect`, all in the image, enters the voxel, leaves it, and only then ends. Rays are
 * lines without width; one that only touches the voxel does not count, nor does any that reaches no farther than
 * `depth_m`, the depth of the voxel's nearest corner or less. */
bool anyRayCrosses(const FrameRays& rays, const GridKey& voxel, const PixelRect& rect, float depth_m);
}  // namespace explore
