// What the world's author says of an opening.
#pragma once

#include "support/building_opening.h"

namespace explore::test
{
/** Labels an opening that is a door or passage: verdict and clear width by what fills it. */
void labelDoor(Sketch& sketch, const WallFrame& wall, const Opening& opening);
}  // namespace explore::test
