// [perception]: the parameters of all perception stages; defaults are the paper's.
#pragma once

#include <explore/perception/corridor.h>
#include <explore/perception/corridor_end.h>
#include <explore/perception/door_gaps.h>
#include <explore/perception/ground.h>
#include <explore/perception/level_view.h>
#include <explore/perception/near_field.h>
#include <explore/perception/obstacles.h>
#include <explore/perception/openings.h>
#include <explore/perception/planes.h>
#include <explore/perception/range_filter.h>
#include <explore/perception/remedies.h>
#include <explore/perception/vanishing_point.h>
#include <explore/perception/voxel_grid.h>
#include <explore/perception/walls.h>

namespace explore
{
enum class PerceptionMethod
{
	full,
	paper
};

struct PerceptionConfig
{
	PerceptionMethod method = PerceptionMethod::full;
	Remedy leave_out = Remedy::none;  ///< of method = full, for comparison
	int seed = 1;                     ///< of every random choice
	RangeFilterConfig range_filter;
	VoxelGridConfig voxel_grid;
	PlaneSearchConfig planes;
	GroundConfig ground;
	WallConfig walls;
	DoorGapConfig door_gaps;
	VanishingPointConfig vanishing_points;
	NearFieldConfig near_field;

	SensorNoiseConfig sensor_noise;
	LevelViewConfig level;
	UprightWallConfig upright_walls;
	OpeningsConfig openings;
	CorridorConfig corridor;
	CorridorEndConfig corridor_ends;
	ObstacleConfig obstacles;
};
/** [perception] */
void describe(FieldVisitor& fields, PerceptionConfig& config);
}  // namespace explore
