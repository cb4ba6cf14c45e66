// What stands and hangs in the rooms of a made-up building.
#pragma once

#include "support/building_plan.h"

namespace explore::test
{
/** Furniture by the room's use, never in the way of doors and leaves. */
void furnish(Sketch& sketch, Plan& plan, Room& room, Dice& dice);
}  // namespace explore::test
