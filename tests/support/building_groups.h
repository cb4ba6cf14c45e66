// Furniture as it stands together, and what hangs and stands about in rooms of any use.
#pragma once

#include "support/building_room.h"

namespace explore::test
{
/** Where the room has no place left, fewer are built. */
void addCupboards(RoomSpace& space, int count, double most_high_m);
void addChairs(RoomSpace& space, int count);
void addCurtains(RoomSpace& space, int count);
void addPeople(RoomSpace& space, int count);
void addColumns(RoomSpace& space, int count);
/** A table with chairs around it. */
void addTableGroup(RoomSpace& space, const PlanSize& size, bool turned);
/** With a chair before it. */
void addDesk(RoomSpace& space);
/** In some rooms, in their middle. */
void layCarpet(RoomSpace& space);
/** Pictures, and here and there a plant, a radiator, a bin, a person, an alcove. */
void decorate(RoomSpace& space);
}  // namespace explore::test
