#include <explore/memory/corridor_sight.h>
#include <explore/memory/frontier_memory.h>

#include <algorithm>

namespace explore
{
namespace
{
DoorLook doorLook(const FrontierMemory& memory, const DepthFrame& frame, const Percepts& percepts,
                  const DoorTrackConfig& config)
{
	DoorLook look;
	look.doors_in_robot = percepts.doors;
	look.map_from_robot = isometryOf(frame.map_from_robot);
	look.robot_from_camera = isometryOf(frame.robot_from_camera);
	look.t_s = mrpt::Clock::toDouble(frame.timestamp);
	look.view = doorQuery(frame, DoorSightConfig{}, config.noise.depth);
	look.reveal = revealQuery(frame);
	look.occupancy = [&memory](const Eigen::Vector3d& point) { return memory.map.stateAt(point); };
	return look;
}

CorridorLook corridorLook(const DepthFrame& frame, const Percepts& percepts)
{
	CorridorLook look;
	look.vanishing_points_in_robot = percepts.vanishing_points;
	look.walls_in_robot = percepts.walls;
	look.map_from_robot = isometryOf(frame.map_from_robot);
	look.robot_from_camera = isometryOf(frame.robot_from_camera);
	look.t_s = mrpt::Clock::toDouble(frame.timestamp);
	look.clear_ahead_m = clearAhead(frame);
	return look;
}

/** The robot stands there: its feet are free. */
void noteStand(FrontierMemory& memory, const DepthFrame& frame)
{
	memory.layers.stood(isometryOf(frame.map_from_robot).translation());
}

void updateTracks(FrontierMemory& memory, const DepthFrame& frame, Percepts& percepts, const RobotConfig& robot,
                  const MemoryConfig& config)
{
	const std::vector<int> doors =
	    update(memory.doors, doorLook(memory, frame, percepts, config.doors), robot, config.doors);
	for (std::size_t i = 0; i < doors.size(); ++i) percepts.doors[i].track = doors[i];
	const std::vector<int> corridors = update(memory.corridors, corridorLook(frame, percepts), config.corridors);
	for (std::size_t i = 0; i < corridors.size(); ++i) percepts.vanishing_points[i].track = corridors[i];
}
}  // namespace

void describe(FieldVisitor& fields, MemoryConfig& config)
{
	fields.section("memory", "What is kept from frame to frame");
	fields.flag("enabled", config.enabled, "false: each frame stands alone");
	fields.flag("tracks", config.tracks, "of doors and corridors; false: the map alone");
	describe(fields, config.map);
	describe(fields, config.layers);
	describe(fields, config.frontiers);
	describe(fields, config.doors);
	describe(fields, config.corridors);
}

FrontierMemory::FrontierMemory(const MemoryConfig& config, const RobotConfig& robot)
    : map(config.map), layers(config.layers, robot, config.map.resolution_m), frontiers(config.frontiers)
{
}

FrontierMemory::FrontierMemory(const MemoryConfig& config, const RobotConfig& robot,
                               std::unique_ptr<octomap::OcTree> old_map)
    : map(config.map, std::move(old_map)),
      layers(config.layers, robot, config.map.resolution_m),
      frontiers(config.frontiers)
{
	layers.rebuild(map.tree());
	frontiers.update(layers);
}

void remember(FrontierMemory& memory, const DepthFrame& frame, Percepts& percepts, const RobotConfig& robot,
              const MemoryConfig& config)
{
	memory.map.insert(frame);
	noteStand(memory, frame);
	memory.layers.update(memory.map.changes());
	memory.frontiers.update(memory.layers);
	update(memory.recent, frame, percepts.obstacles_in_robot, memory.layers, robot);
	if (config.tracks) updateTracks(memory, frame, percepts, robot, config);
}
}  // namespace explore
