#include <explore/memory/body_layers_config.h>

#include <algorithm>
#include <cmath>

namespace explore
{
double lowestOfBody(const BodyLayersConfig& config, double resolution_m)
{
	constexpr double kRounding = 1e-6;  // in voxels: a floor at a voxel's lower end lies in that one
	const double voxel = std::floor(config.floor_z_m / resolution_m + kRounding);
	return std::max(config.lowest_m, (voxel + 1.0) * resolution_m - config.floor_z_m);
}

void describe(FieldVisitor& fields, BodyLayersConfig& config)
{
	fields.section("layers", "The map as the robot's body meets it: cells that are free, occupied, a drop or unknown.");
	fields.real("floor_z", config.floor_z_m, {-50.0, 50.0}, "m", "Height of the floor in the map.");
	fields.real("lowest", config.lowest_m, {0.0, 1.0}, "m",
	            "ground only: the robot rolls over what is lower, and over the voxel that the floor lies in.");
	fields.real("layer_step", config.layer_step_m, {0.05, 2.0}, "m", "mav only: between the altitudes of layers.");
	fields.real("body_margin", config.body_margin_m, {0.0, 1.0}, "m",
	            "mav only: what is this near above or below the body is in its way.");
	fields.real("drop", config.drop_m, {0.02, 1.0}, "m",
	            "ground only: free space that lies deeper below the floor is a drop where no floor is seen.");
	fields.real("drop_reach", config.drop_reach_m, {0.05, 2.0}, "m",
	            "ground only: how far below the floor such space is looked for.");
	fields.real("floor_tolerance", config.floor_tolerance_m, {0.01, 0.5}, "m",
	            "ground only: what is occupied within this height of the floor carries the robot.");
	fields.real("growth", config.growth_m, {0.5, 100.0}, "m", "Steps in which the rectangle of cells grows.");
	fields.real("max_edge", config.max_edge_m, {10.0, 3000.0}, "m",
	            "A map whose rectangle of cells would be longer is refused.");
}
}  // namespace explore
