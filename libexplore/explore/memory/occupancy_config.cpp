#include <explore/memory/occupancy_config.h>
#include <octomap/octomap_utils.h>

namespace explore
{
void describe(FieldVisitor& fields, OccupancyConfig& config)
{
	fields.section("map", "The map of occupied and free space that is kept across frames.");
	fields.real("resolution", config.resolution_m, {0.02, 0.5}, "m", "Edge of a voxel.");
	fields.real("range", config.range_m, {1.0, 20.0}, "m",
	            "Measurements count up to this distance; beyond it a ray says that space is free up to here.");
	fields.real(
	    "window_margin", config.window_margin_m, {1.25, 100.0}, "m",
	    "How far beyond the range the map is kept at hand. More takes memory and saves work; the map is the same.");
	fields.real("hit_probability", config.hit_probability, {0.51, 0.99}, "",
	            "How surely a voxel is occupied in which a ray ends.");
	fields.real("miss_probability", config.miss_probability, {0.01, 0.49}, "",
	            "How surely a voxel is occupied through which a ray passes.");
	fields.real("min_probability", config.min_probability, {0.01, 0.49}, "",
	            "A voxel never gets freer than this, so that a few hits change it again.");
	fields.real("max_probability", config.max_probability, {0.51, 0.99}, "",
	            "A voxel never gets more surely occupied than this, so that some misses change it again.");
	fields.real("second_look_range", config.second_look_range_m, {0.0, 20.0}, "m",
	            "Up to here, what returned light a moment ago and returns none now, seen from the same place, is "
	            "forgotten: someone who left an open hall. 0 = never.");
	fields.real("shadow_baseline", config.shadow_baseline_m, {0.0, 0.5}, "m",
	            "Distance of the sensor's projector from its camera: beside near things its pattern is in shadow, and "
	            "no return says nothing there. 0 = a sensor without shadows.");
}

SensorModel::SensorModel(const OccupancyConfig& config)
    : hit(octomap::logodds(config.hit_probability)),
      miss(octomap::logodds(config.miss_probability)),
      lowest(octomap::logodds(config.min_probability)),
      highest(octomap::logodds(config.max_probability))
{
}
}  // namespace explore
