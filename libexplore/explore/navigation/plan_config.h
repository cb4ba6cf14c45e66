// What planning over the map goes by: clearances, bounds, and what a look is worth.
#pragma once

#include <explore/config/fields.h>

#include <string>

namespace explore
{
struct PlanConfig
{
	double clearance_m = 0.05;              ///< space where the body's radius plus this is free is to be explored
	double squeeze_m = 0.02;                ///< ways keep at least the body's radius plus this from what stands there
	double comfort_m = 0.45;                ///< from the body's centre: ways that keep this far away cost nothing extra
	double clearance_cost = 2;              ///< a way as near as it may be costs so much more a metre
	double view_range_m = 4.0;              ///< a look is held to show unknown space up to here
	double view_angle_rad = 0.9948376736;   ///< 57°: the camera's field of view
	double view_height_rad = 0.7853981634;  ///< 45°: in height
	double view_depth_m = 1.0;              ///< a look is held to show so much of unknown space along each ray
	double min_gain_m2 = 0.06;              ///< unknown space that is worth a look
	double pocket_worth = 10;               ///< metres of way that a square metre of enclosed unknown space is worth
	double turn_cost_m = 0.15;              ///< a radian's turn counts as so much way
	double arrive_m = 0.15;                 ///< a goal is reached within this
	double home_m = 0.05;                   ///< home is reached within this
	double switch_gain_m = 1.5;             ///< a better tour must be this much shorter before the goal is changed
	double return_gain_m = 5.0;             ///< the same for a goal that was left lately
	double period_s = 1.0;                  ///< between plans while nothing forces one
};
/** [plan] */
void describe(FieldVisitor& fields, PlanConfig& config);

/** Where the robot may go at all, map frame. */
struct BoundsConfig
{
	bool enabled = false;
	double min_x_m = -10, max_x_m = 10, min_y_m = -10, max_y_m = 10;
	/** Polygons to stay out of: "x y, x y, x y; x y, …" in metres. */
	std::string keep_out;
};
/** [bounds] */
void describe(FieldVisitor& fields, BoundsConfig& config);
}  // namespace explore
