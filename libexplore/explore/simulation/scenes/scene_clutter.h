// Fills rooms with what usually stands and hangs in them.
#pragma once

#include <explore/simulation/scenes/scene_walls.h>

namespace explore::simulation
{
/** Up to `things` pieces of furniture at the walls and anywhere, where the floor is free; fewer where it is not. */
void furnish(Sketch& sketch, const Space& space, int things);
/** Pictures, boards and radiators on those sides. */
void decorate(Sketch& sketch, const Space& space, std::initializer_list<Side> sides);
}  // namespace explore::simulation
