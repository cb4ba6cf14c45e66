// The free floor of one room of a made-up building, and places for furniture on it.
#pragma once

#include "support/building_pieces.h"
#include "support/building_plan.h"

#include <functional>

namespace explore::test
{
struct RoomSpace
{
	using Build = std::function<void(const Place&)>;

	Sketch& sketch;
	const Plan& plan;
	Room& room;
	Dice& dice;

	/** Takes the area where it is inside the room and `apart_m` from all that is taken; false where it is not. */
	bool take(const Area& area, double apart_m = 0);
	/** Builds a piece of that size with its back (−x) to a wall; false where no place was found. */
	bool atWall(const PlanSize& size, const Build& build);
	/** Builds it somewhere in the room, turned as it likes, or by right angles where `turned` is false. */
	bool free(const PlanSize& size, const Build& build, double from_wall_m = 0.5, bool turned = true);
};
}  // namespace explore::test
