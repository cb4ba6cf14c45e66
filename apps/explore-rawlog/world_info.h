// What a simulated world contains, for people: the world half of explore-rawlog info.
#pragma once

#include <explore/simulation/world.h>

#include <string>

namespace explore::app
{
/** One fact a line: geometry, materials, things that move, labels, and what was left out when it was loaded. */
std::string textOf(const simulation::World& world);
}  // namespace explore::app
