// The wall that faces one already found, where it is too far away or too hidden to be found by itself.
#pragma once

#include <explore/perception/corridor_walls.h>

#include <optional>

namespace explore
{
/** The plane parallel to `wall`, on the camera's other side and `facing` away from it, along which most of the view's
 *  surfaces run: the direction is known, so one number is left to find, over the sensor's whole range. No value where
 *  less than 0.6 m of it is seen. */
std::optional<UprightWall> companionOf(const UprightWall& wall, const PlanPoints& points, double spacing_rad,
                                       const FacingConfig& facing);
}  // namespace explore
