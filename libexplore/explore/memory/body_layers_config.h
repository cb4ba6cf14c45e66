// Which heights a robot's body sweeps, and how the layers of cells over the map are kept.
#pragma once

#include <explore/config/fields.h>

namespace explore
{
struct BodyLayersConfig
{
	double floor_z_m = 0.0;            ///< of the floor in the map
	double lowest_m = 0.05;            ///< ground robot: it rolls over what is lower
	double layer_step_m = 0.25;        ///< MAV: between altitudes
	double body_margin_m = 0.05;       ///< MAV: added to the body above and below
	double drop_m = 0.10;              ///< ground robot: how far below the floor free space is a drop …
	double drop_reach_m = 0.50;        ///< … and how far below it that is looked for
	double floor_tolerance_m = 0.075;  ///< the floor is what is occupied this near to floor_z_m
	double growth_m = 12.8;            ///< the rectangle of cells grows in such steps
	double max_edge_m = 400.0;         ///< but no longer than this
};
/** Where the body of a ground robot begins, above the floor [m]: lowest_m, but above the voxel that the floor lies in,
 * for that is occupied everywhere. */
[[nodiscard]] double lowestOfBody(const BodyLayersConfig& config, double resolution_m);

/** [layers] */
void describe(FieldVisitor& fields, BodyLayersConfig& config);
}  // namespace explore
