// What the map of occupied and free space is made with: voxel size, range, and how much a measurement counts.
#pragma once

#include <explore/config/fields.h>

namespace explore
{
/** Probabilities are those of OctoMap's sensor model (Hornung et al. 2013, "OctoMap", §3.2), whose defaults they have.
 */
struct OccupancyConfig
{
	double resolution_m = 0.05;  ///< edge of a voxel
	double range_m = 5.0;        ///< along the ray; what is farther counts as free up to here
	/** How far beyond the range the map is kept at hand: more takes memory and saves work. The map is the same. */
	double window_margin_m = 1.25;
	double hit_probability = 0.7, miss_probability = 0.4;
	double min_probability = 0.12, max_probability = 0.97;  ///< where a voxel's probability is clamped
	/** Up to here, things that return no light any more are forgotten (second_look.h); 0 = never. */
	double second_look_range_m = 4.0;
	double shadow_baseline_m = 0.08;  ///< camera to projector: how far the shadows of near things reach; 0 = none
};
/** [map] */
void describe(FieldVisitor& fields, OccupancyConfig& config);

/** The same as additions to a voxel's log-odds, in OctoMap's own precision. A voxel is occupied from 0 on. */
struct SensorModel
{
	float hit, miss, lowest, highest;

	explicit SensorModel(const OccupancyConfig& config);
};
}  // namespace explore
