// Corridors, seen along their axis.
#pragma once

#include <explore/simulation/scenes/scene_rooms.h>

namespace explore::simulation
{
struct CorridorDraw
{
	Span width_m{1.2, 3.0};
	Span ahead_m{3.5, 11.0};  ///< from the robot to the end
	Span yaw_deg{-12, 12};    ///< of the view from the axis
};
/** A corridor along the building's y axis with the robot in it: space, viewpoint, no doors. */
RoomPlan drawCorridor(Sketch& sketch, const CorridorDraw& draw = {});

/** A corridor with doors of that width on both sides, one on each side where the camera sees it, and perhaps one at its
 *  end; the doors' ids begin with "left", "right" and "end". */
void drawDoorCorridor(Sketch& sketch, const Span& door_width_m);
}  // namespace explore::simulation
