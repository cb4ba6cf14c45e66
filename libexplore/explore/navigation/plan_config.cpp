#include <explore/navigation/plan_config.h>

namespace explore
{
void describe(FieldVisitor& fields, PlanConfig& config)
{
	fields.section("plan", "Planning over the map");
	fields.real("clearance", config.clearance_m, {0.0, 1.0}, "m",
	            "space where the body's radius plus this is free is to be explored");
	fields.real("squeeze", config.squeeze_m, {0.0, 1.0}, "m",
	            "ways keep at least the body's radius plus this from what stands there");
	fields.real("comfort", config.comfort_m, {0.05, 2.0}, "m",
	            "from the body's centre: ways that keep this far from things cost nothing extra");
	fields.real("clearance_cost", config.clearance_cost, {0.0, 4.0}, "",
	            "a way as near to things as it may be costs so many times more a metre");
	fields.real("view_range", config.view_range_m, {1.0, 20.0}, "m", "a look is held to show unknown space up to here");
	fields.degrees("view_angle_deg", config.view_angle_rad, {5.0, 180.0}, "the camera's horizontal field of view");
	fields.degrees("view_height_deg", config.view_height_rad, {5.0, 180.0},
	               "mav only: the camera's vertical field of view, by which a look shows other altitudes");
	fields.real("view_depth", config.view_depth_m, {0.1, 10.0}, "m",
	            "a look is held to show so much of unknown space along each ray");
	fields.real("min_gain", config.min_gain_m2, {0.0, 10.0}, "m2", "unknown space that is worth a look");
	fields.real(
	    "pocket_worth", config.pocket_worth, {0.0, 1e6}, "m/m2",
	    "explore only: unknown space that what is known encloses is worth so much way; what costs more is left");
	fields.real("turn_cost", config.turn_cost_m, {0.0, 10.0}, "m", "a radian's turn counts as so much way");
	fields.real("arrive", config.arrive_m, {0.02, 2.0}, "m", "a goal is reached within this");
	fields.real("home", config.home_m, {0.01, 2.0}, "m", "home is reached within this");
	fields.real("switch_gain", config.switch_gain_m, {0.0, 100.0}, "m",
	            "another goal must make the tour so much shorter before the robot leaves its own");
	fields.real(
	    "return_gain", config.return_gain_m, {0.0, 1000.0}, "m",
	    "a goal that the robot left less than 20 s ago must make the tour so much shorter before it comes first again");
	fields.real("period", config.period_s, {0.05, 60.0}, "s", "between plans while nothing forces one");
}

void describe(FieldVisitor& fields, BoundsConfig& config)
{
	fields.section("bounds", "Where the robot may go");
	fields.flag("enabled", config.enabled, "keep the robot between the four limits below");
	fields.real("min_x", config.min_x_m, {-1000, 1000}, "m", "map frame, of the robot's centre");
	fields.real("max_x", config.max_x_m, {-1000, 1000}, "m", "see min_x");
	fields.real("min_y", config.min_y_m, {-1000, 1000}, "m", "see min_x");
	fields.real("max_y", config.max_y_m, {-1000, 1000}, "m", "see min_x");
	fields.text("keep_out", config.keep_out,
	            "polygons that the robot's centre stays out of, map frame: corners x y, divided by commas; polygons by "
	            "semicolons");
}
}  // namespace explore
