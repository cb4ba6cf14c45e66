// What lies behind the doorways of a wall.
#pragma once

#include <explore/simulation/scenes/scene_doors.h>

#include <vector>

namespace explore::simulation
{
/** Builds rooms, corridors, dark halls and stairwells behind the doorways, within `limits` along the wall, with up to
 *  `things` pieces of furniture each. Leaves that would not fit there are taken off. */
void buildBeyond(Sketch& sketch, const WallPlan& wall, std::vector<DoorPlan>& doors, const Span& limits, int things);
}  // namespace explore::simulation
