// One opening in a wall of a made-up building: door, passage, window or niche, with all that hangs and stands in it.
#pragma once

#include "support/building_sketch.h"

#include <array>

namespace explore::test
{
enum class Filling
{
	none,
	leaf,          ///< one hinged leaf
	two_leaves,    ///< both hinged, the same angle
	fixed_leaf,    ///< two leaves of which one is bolted: the opening is what the other one leaves
	sliding_face,  ///< a leaf that hangs before one face
	sliding_wall,  ///< a leaf that runs in the middle of the wall
	curtain,
	person,
	boxes,
	counter,  ///< solid up to the sill
	window,
	niche
};

struct Opening
{
	std::string id;
	double middle_m = 0;  ///< along the wall
	double width_m = 0.9;
	double low_m = 0;   ///< of a window or niche: its sill; of a door: its threshold; of a counter: its top
	double high_m = 2;  ///< the lintel; at the wall's height or above there is none
	double arch_m = 0;  ///< rise of an arch below high_m
	Filling filling = Filling::none;
	Look leaf_look = Look::wood;
	double angle_rad = 0;    ///< of the leaf; 0 = shut
	double slid_m = 0;       ///< what a sliding leaf or boxes leave free
	double recess_m = 0;     ///< of the leaf behind the face it opens at
	double depth_m = 0.15;   ///< of a niche
	int side = 1;            ///< the face to which leaf, curtain or niche belongs: 1 = left of the wall
	bool hinge_left = true;  ///< seen along the wall, the hinge is at its start
	double casing_m = 0, casing_proud_m = 0;
	std::array<bool, 2> casing_at{true, true};  ///< start, end
	double stop_m = 0;
	std::array<double, 2> corner_m{10, 10};  ///< from the jambs to walls across on its side, start and end
	bool drop = false;                       ///< no floor behind
	bool passage = false;                    ///< no door, by its size or lintel
};

/** What the wall around the opening is. */
struct WallFrame
{
	Place start;  ///< the wall's axis runs along x
	double thickness_m = 0.12, height_m = 2.6;
};

/** The opening's part of the wall (above, below and within it), what fills it, and its label where it is a door. */
void buildOpening(Sketch& sketch, const WallFrame& wall, const Opening& opening, Dice& dice);
}  // namespace explore::test
