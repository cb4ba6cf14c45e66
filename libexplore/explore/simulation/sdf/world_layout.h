// How a world falls into bytes.
#pragma once

#include <explore/core/byte_archive.h>
#include <explore/simulation/world.h>

namespace explore::simulation
{
template <class Archive>
void exchange(Archive& archive, Material& material)
{
	archive(material.name), archive(material.surface), archive(material.color);
}

template <class Archive>
void exchange(Archive& archive, TriangleMesh& mesh)
{
	archive(mesh.vertices), archive(mesh.triangles);
}

template <class Archive>
void exchange(Archive& archive, Body& body)
{
	archive(body.name), archive(body.material);
}

template <class Archive>
void exchange(Archive& archive, Waypoint& waypoint)
{
	archive(waypoint.t_s), archive(waypoint.position_in_map), archive(waypoint.z_m), archive(waypoint.yaw_rad);
}

template <class Archive>
void exchange(Archive& archive, MovingBody& body)
{
	archive(body.name), archive(body.kind), archive(body.mesh), archive(body.material), archive(body.track);
	archive(body.loop), archive(body.radius_m), archive(body.height_m), archive(body.gap_m);
}

template <class Archive>
void exchange(Archive& archive, DoorLabel& door)
{
	archive(door.id), archive(door.floor_center_in_map), archive(door.normal_in_map), archive(door.width_m);
	archive(door.height_m), archive(door.depth_m), archive(door.clear_width_m), archive(door.sill_m);
	archive(door.verdict);
}

template <class Archive>
void exchange(Archive& archive, CorridorLabel& corridor)
{
	archive(corridor.id), archive(corridor.start_in_map), archive(corridor.end_in_map), archive(corridor.width_m);
}

template <class Archive>
void exchange(Archive& archive, ObstacleLabel& obstacle)
{
	archive(obstacle.kind), archive(obstacle.floor_center_in_map), archive(obstacle.radius_m);
	archive(obstacle.height_m);
}

template <class Archive>
void exchange(Archive& archive, Spawn& spawn)
{
	archive(spawn.name), archive(spawn.position_in_map), archive(spawn.yaw_rad);
}

template <class Archive>
void exchange(Archive& archive, Route& route)
{
	archive(route.name), archive(route.points_in_map);
}

template <class Archive>
void exchange(Archive& archive, World& world)
{
	archive(world.name), archive(world.materials), archive(world.mesh), archive(world.body_of_triangle);
	archive(world.bodies), archive(world.moving), archive(world.doors), archive(world.corridors);
	archive(world.obstacles), archive(world.spawns), archive(world.routes), archive(world.warnings);
}

}  // namespace explore::simulation
