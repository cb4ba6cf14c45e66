// Where a corridor opens into a hall or another corridor: an opening whose own wall is not seen from inside.
#pragma once

#include <explore/config/fields.h>
#include <explore/perception/corridor_pairs.h>

#include <Eigen/Core>
#include <vector>

namespace explore
{
struct CorridorEndConfig
{
	double min_wall_m = 0.15;         ///< of either side wall before its edge, for a camera between the walls
	double min_wall_outside_m = 0.9;  ///< the same where the walls are seen to begin: a door's jambs are shorter
	double free_beyond_m = 0.8;       ///< in the corridor's direction, behind the end
	double wider_m = 0.3;             ///< more than the corridor is free behind its end at either side …
	double much_wider_m = 0.6;        ///< … and this much at one of them: cupboards are no deeper
	double min_through = 0.5;         ///< share of the rays between the edges, of those with a return, that lead on
	double min_open_lanes = 0.5;      ///< share of the end's width in which any does
};
/** Field list of the above; without a section of its own. */
void describe(FieldVisitor& fields, CorridorEndConfig& config);

/** An opening on the floor of the level frame, and what speaks for it. */
struct CorridorEnd
{
	Eigen::Vector2d center = Eigen::Vector2d::Zero();
	Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< unit, toward the camera
	double width_m = 0;
	double clear_width_m = 0;                         ///< widest stretch without anything in the way
	int left_rows = 0, right_rows = 0;                ///< thinned image rows that show the edges
	int left_behind_rows = 0, right_behind_rows = 0;  ///< of these: with something behind; else there is no return
	int left_floor = 0, right_floor = 0;       ///< samples of the floor beside the end, behind the side walls' planes
	double left_wall_m = 0, right_wall_m = 0;  ///< length of wall seen before the edges
	int passed = 0;                            ///< samples beyond the end, below a robot's height
	double through = 0;                        ///< their share of those that come between the edges at all
	double open_lanes = 0;                     ///< share of the width in which there are any
	double no_return = 0;                      ///< share of all rays between the edges that come back with nothing
	double wall_again_m = 0;                   ///< length of wall met again past the edge, of the worse side
};

/** The ends of the corridors between any two facing walls, however little of these is seen. Dead ends are none, and
 * where only one of the walls ends there is none either. */
std::vector<CorridorEnd> findCorridorEnds(const CorridorPairs& pairs, const CorridorEndConfig& config);
}  // namespace explore
