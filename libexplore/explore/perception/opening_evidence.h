// What the rays in and beside an opening say about it: remedies 2, 3, 4, 6 and 15 as measurements, no decisions.
#pragma once

#include <explore/core/results.h>
#include <explore/perception/jamb_fit.h>

#include <Eigen/Core>
#include <vector>

namespace explore
{
struct OpeningConfig
{
	double max_width_m = 4.0;
	double length_margin_m = 0.3;  ///< free depth behind the wall: the robot's diameter + this
	double front_m = 0.3;          ///< what stands nearer before the opening narrows it
	double leaf_m = 0.9;           ///< a leaf reaches that far before it
	double standing_top_m = 1.5;   ///< things in a doorway are looked for up to this height
	int rays = 12000;              ///< looked at per opening, about
	bool depth_behind = true;      ///< false: any depth behind the wall is enough (for comparison)
};
void describe(FieldVisitor& fields, OpeningConfig& config);

/** An opening in a wall with its two ends. */
struct OpeningFrame
{
	Jamb left, right;
	[[nodiscard]] double width_m() const { return right.along_m - left.along_m; }
	[[nodiscard]] double middle_m() const { return 0.5 * (left.along_m + right.along_m); }
};

struct OpeningMeasure
{
	OpeningEvidence evidence;
	double clear_width_m = 0;     ///< see clearWidth()
	double seen_lane_m = 0;       ///< see DoorwayPlan::seenLane_m()
	double across_left = 0;       ///< share of the rays just beyond the left jamb that meet a surface across or before
	double across_right = 0;      ///< the wall; and of the right one
	double through_run_m = 0;     ///< longest stretch, along the wall, of rays that mostly lead through
	double stop_depth_m = 0;      ///< median depth behind the wall at which stopped rays end
	double standing_m = 0;        ///< top of what stands in the opening; 0 = nothing does
	bool at_jamb = false;         ///< what stands there begins at a jamb: a leaf
	double floor_missing = 0;     ///< share of the rays to the floor right behind that return nothing
	double top_beside_m = 0;      ///< top of the lower one of the things beside it; 2.8 m where no top was seen
	double reveal = 0;            ///< share of the rays that end on the far jamb's face or a leaf open there
	double reveal_m = 0;          ///< how far behind the wall's face that was seen
	double back_wall = 0;         ///< share of these that end at the greatest depth: much where a niche ends
	int rays = 0;                 ///< unoccluded rays through the opening
	double holes_beside = 0;      ///< OpeningEvidence::speckle of the wall beside it
	double no_return_beside = 0;  ///< share of the rays to the wall beside it
};

/** `standing_bottom_m` … max(standing_top, robot) are the heights at which things in the way count. */
struct BodyBand
{
	double bottom_m, top_m;
};

OpeningMeasure measureOpening(const RayJudge& judge, const LevelView& view, const UprightWall& wall,
                              const OpeningFrame& frame, const BodyBand& body, double free_depth_m,
                              const OpeningConfig& config);
}  // namespace explore
