// Whole rooms and corridors with doorways in their walls, and what lies behind these.
#pragma once

#include <explore/simulation/scenes/scene_doors.h>
#include <explore/simulation/scenes/scene_view.h>

#include <array>
#include <optional>
#include <vector>

namespace explore::simulation
{
/** What one wall of a room has; along as the wall's face counts it. */
struct SidePlan
{
	std::vector<DoorPlan> doors;
	std::vector<Opening> openings;  ///< holes without a label
};

/** The room or corridor in which the robot stands. */
struct RoomPlan
{
	Space space;
	std::array<SidePlan, 4> sides;  ///< by Side
	int things = 4;                 ///< pieces of furniture at most, here and in every space behind
	bool decorated = true;

	SidePlan& operator[](Side side) { return sides[static_cast<std::size_t>(side)]; }
};
/** The face of that side as a wall without holes. */
WallPlan wallOf(Sketch& sketch, const RoomPlan& room, Side side);
/** Walls, doorways, the spaces behind them, furniture, and the label of a corridor. */
void buildRoom(Sketch& sketch, RoomPlan room);

/** A room of which one wall matters. Along counts on that wall's face, wherever the room will end; the face is the
 *  building's x axis. */
struct FrontPlan
{
	SidePlan side;
	/** Taken by anything that the scene is about. */
	Span extent{0, 0};
	/** Where the room ends along the wall; drawn where there is no value. */
	std::optional<double> low_m, high_m;
	double step_m = 0;  ///< the wall's part before the first doorway stands so much forward (< 0: the other part)
	int things = 5;
	bool decorated = true;
};
/** After the viewpoint: a room around it and the front's doorways. */
void buildFront(Sketch& sketch, FrontPlan front);
/** A wall with that doorway, which is seen from the range; the rest of the front is as given. */
void drawDoorway(Sketch& sketch, const DoorPlan& door, const ViewRange& range, FrontPlan front = {});
}  // namespace explore::simulation
