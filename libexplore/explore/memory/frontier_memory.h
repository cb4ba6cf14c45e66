// All that is remembered of the world: the map, where the body fits, its frontiers, and the tracks of doors and
// corridors.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/results.h>
#include <explore/core/robot.h>
#include <explore/memory/body_layers.h>
#include <explore/memory/corridor_tracks.h>
#include <explore/memory/door_tracks.h>
#include <explore/memory/frontiers.h>
#include <explore/memory/occupancy.h>
#include <explore/memory/recent_obstacles.h>

namespace explore
{
struct MemoryConfig
{
	bool enabled = true;  ///< false: each frame stands alone
	bool tracks = true;   ///< of doors and corridors; false: the map alone
	OccupancyConfig map;
	BodyLayersConfig layers;
	FrontierConfig frontiers;
	DoorTrackConfig doors;
	CorridorTrackConfig corridors;
};
/** [memory] [map] [layers] [frontiers] [door_tracks] [corridor_tracks] */
void describe(FieldVisitor& fields, MemoryConfig& config);

struct FrontierMemory
{
	FrontierMemory(const MemoryConfig& config, const RobotConfig& robot);
	/** Goes on with an older map. Throws ConfigError when its voxels have another size. */
	FrontierMemory(const MemoryConfig& config, const RobotConfig& robot, std::unique_ptr<octomap::OcTree> old_map);

	Occupancy map;
	BodyLayers layers;
	Frontiers frontiers;
	DoorTracks doors;
	CorridorTracks corridors;
	RecentObstacles recent;
};

/** Writes a memory, or reads it into an empty one that was made alike: both go on in the same way then. */
template <class Archive>
void exchange(Archive& archive, FrontierMemory& memory)
{
	auto& [map, layers, frontiers, doors, corridors, recent] = memory;  // all there is
	archive(map), archive(layers), archive(doors), archive(corridors), archive(recent);
	if (Archive::kReads) frontiers.update(layers);
}

/** Adds one frame and what was perceived in it, whose doors and vanishing points get the numbers of their tracks. The
 * frame's pose is taken as it is. */
void remember(FrontierMemory& memory, const DepthFrame& frame, Percepts& percepts, const RobotConfig& robot,
              const MemoryConfig& config);
}  // namespace explore
