// Worlds made of boxes for the truth and robot tests, and what can be said of them without rays.
#pragma once

#include <explore/core/geometry.h>
#include <explore/core/robot.h>
#include <explore/simulation/shapes.h>
#include <explore/simulation/truth_rays.h>

#include <algorithm>
#include <string>
#include <vector>

namespace explore::test
{
using Eigen::Vector2d;
using Eigen::Vector3d;

struct Box
{
	Vector3d low, high;
};

inline void addBox(simulation::World& world, const Box& box, const std::string& name = "box",
                   const std::string& material = "grey")
{
	Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
	placed.translation() = 0.5 * (box.low + box.high);
	simulation::TriangleMesh piece;
	simulation::append(piece, simulation::boxMesh(box.high - box.low), placed);
	world.add(name, piece, world.materialNamed(material));
}

/** A hall of 12 m × 6 m, the origin 2 m from its west end, on its axis. */
inline simulation::World hall()
{
	simulation::World world;
	addBox(world, {{-3.0, -4.0, -0.1}, {11.0, 4.0, 0.0}}, "floor");
	addBox(world, {{-2.1, -3.1, 0.0}, {-2.0, 3.1, 2.5}}, "west");
	addBox(world, {{10.0, -3.1, 0.0}, {10.1, 3.1, 2.5}}, "east");
	addBox(world, {{-2.0, 3.0, 0.0}, {10.0, 3.1, 2.5}}, "north");
	addBox(world, {{-2.0, -3.1, 0.0}, {10.0, -3.0, 2.5}}, "south");
	return world;
}

/** A wall across the x axis, its near face at `face_x`, with one opening around y = 0. */
struct DoorWall
{
	double face_x = 3.0, thickness_m = 0.1, width_m = 0.9, height_m = 2.0;
	double wall_height_m = 2.6, half_length_m = 4.0;
};

inline std::vector<Box> boxesOf(const DoorWall& wall)
{
	const double x = wall.face_x, far = x + wall.thickness_m, side = 0.5 * wall.width_m, end = wall.half_length_m;
	return {{{x, side, 0.0}, {far, end, wall.wall_height_m}},
	        {{x, -end, 0.0}, {far, -side, wall.wall_height_m}},
	        {{x, -side, wall.height_m}, {far, side, wall.wall_height_m}}};
}

inline simulation::DoorLabel labelOf(const DoorWall& wall, const std::string& id = "door")
{
	simulation::DoorLabel label;
	label.id = id;
	label.floor_center_in_map = {wall.face_x + 0.5 * wall.thickness_m, 0.0, 0.0};
	label.normal_in_map = -Vector3d::UnitX();
	label.width_m = label.clear_width_m = wall.width_m;
	label.height_m = wall.height_m;
	label.depth_m = wall.thickness_m;
	return label;
}

inline simulation::World worldWith(const DoorWall& wall)
{
	simulation::World world;
	for (const Box& box : boxesOf(wall)) addBox(world, box, "wall");
	world.doors.push_back(labelOf(wall));
	return world;
}

/** 90° across, 2 · atan(3/4) along the columns. */
inline simulation::TruthCamera wideCamera(double height_m = 0.5)
{
	return {{320, 240, 160, 160, 159.5, 119.5}, {0.0, 0.0, height_m, 0, 0, 0}};
}

/** Whether the straight line between two points runs through the box (slab test). */
inline bool crosses(const Vector3d& from, const Vector3d& to, const Box& box)
{
	double enter = 0.0, leave = 1.0;
	for (int axis = 0; axis < 3; ++axis)
	{
		const double step = to[axis] - from[axis];
		double a = (box.low[axis] - from[axis]) / step, b = (box.high[axis] - from[axis]) / step;
		if (a > b) std::swap(a, b);
		enter = std::max(enter, a);
		leave = std::min(leave, b);
	}
	return enter <= leave;
}

/** The MAV of doc/definitions.md. */
inline RobotConfig mav()
{
	RobotConfig robot;
	robot.kind = RobotKind::mav;
	robot.radius_m = 0.3;
	robot.height_m = 0.25;
	robot.max_speed_mps = 0.8;
	return robot;
}
}  // namespace explore::test
