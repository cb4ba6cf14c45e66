// Walls with holes, rooms and corridors, floors and ceilings of made-up buildings.
#pragma once

#include <explore/simulation/scenes/scene_sketch.h>

#include <initializer_list>

namespace explore::simulation
{
/** A rectangular hole through a wall. */
struct Opening
{
	Span along;
	Span z;             ///< from its sill to its lintel; up to the wall's top or beyond = no lintel
	bool cased = true;  ///< gets the moulding of the building
};

struct WallPlan
{
	WallFrame frame;  ///< its face on the robot's side
	Span along;
	double thickness_m = 0.12, height_m = 2.6;
	std::vector<Opening> openings;  ///< in any order, not overlapping
	std::string body = "wall";
	std::string material = "plaster";
	bool skirted = true;
};

/** As the building's style has them, without holes. */
WallPlan plainWall(Sketch& sketch, const WallFrame& frame, const Span& along);
void buildWall(Sketch& sketch, WallPlan wall);

/** The sides of a space, as seen by somebody who stands in it and looks along +behind. */
enum class Side
{
	near,
	far,
	left,
	right
};
/** The face of that side, seen from inside; along runs from 0. */
WallFrame faceOf(const Space& space, Side side);
double lengthOf(const Space& space, Side side);
/** Plain walls outside of these sides, of that material. */
void enclose(Sketch& sketch, const Space& space, std::initializer_list<Side> sides,
             const std::string& material = "plaster");

/** A floor under all that was built so far (but for the holes) and, where the style has one, the ceiling. */
void layFloorAndCeiling(Sketch& sketch);

/** The two long sides of a space that is narrow enough to be a corridor become one in the truth. */
void labelCorridor(Sketch& sketch, const Space& space);
}  // namespace explore::simulation
