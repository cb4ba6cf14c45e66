// A world as the simulator knows it: baked triangles with materials, things that move, and the labels of its author.
#pragma once

#include <explore/core/results.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace explore::simulation
{
/** How a surface answers an infrared pattern. */
enum class Surface
{
	matte,
	black,   ///< absorbs: no return
	glass,   ///< returns itself, or what is behind, or nothing
	mirror,  ///< returns the mirrored room
};

/** Materials are recognised by name: one that contains "glass", "mirror" or "black" (any case) is that surface.
 * Gazebo's own scripts, "Gazebo/Black" and the like, are mere colours. */
Surface surfaceOf(const std::string& material_name);

struct Material
{
	std::string name;
	Surface surface = Surface::matte;
	Eigen::Vector3f color{0.7F, 0.7F, 0.7F};  ///< diffuse, 0–1
};

struct TriangleMesh
{
	std::vector<Eigen::Vector3f> vertices;
	std::vector<std::array<std::uint32_t, 3>> triangles;
};

/** A run of triangles that belong together and look alike. */
struct Body
{
	std::string name;          ///< model::link::visual
	std::size_t material = 0;  ///< index into World::materials
};

/** A time-stamped place of a moving body on the floor plan. */
struct Waypoint
{
	double t_s = 0;
	Eigen::Vector2d position_in_map = Eigen::Vector2d::Zero();
	double z_m = 0, yaw_rad = 0;
};

/** A person or thing on a fixed track. Waits while the robot is within `gap_m` of it and in its way. */
struct MovingBody
{
	std::string name, kind;  ///< kind: "person", "box", …
	TriangleMesh mesh;       ///< in its own frame: x forward, z up, origin on the floor
	std::size_t material = 0;
	std::vector<Waypoint> track;  ///< by time, linear between; at least one
	bool loop = true;             ///< starts again after the last waypoint
	double radius_m = 0.3, height_m = 1.75;
	double gap_m = 0.4;
};

/** The author's word on an opening. */
struct DoorLabel
{
	std::string id;
	Eigen::Vector3d floor_center_in_map = Eigen::Vector3d::Zero();  ///< middle of the opening, on the floor
	Eigen::Vector3d normal_in_map = Eigen::Vector3d::UnitX();       ///< horizontal; either side
	double width_m = 0;
	std::optional<double> height_m;  ///< lintel above the floor; no value = none
	double depth_m = 0.1;            ///< of the wall, centred on floor_center
	double clear_width_m = 0;        ///< what leaf and obstacles leave free
	double sill_m = 0;               ///< height of a threshold or counter across it
	Verdict verdict = Verdict::open;
};

/** Two facing walls. */
struct CorridorLabel
{
	std::string id;
	Eigen::Vector2d start_in_map = Eigen::Vector2d::Zero(), end_in_map = Eigen::Vector2d::Zero();  ///< of its axis
	double width_m = 0;
};

/** Something that stands in the way, as its author names it. */
struct ObstacleLabel
{
	std::string kind;
	Eigen::Vector3d floor_center_in_map = Eigen::Vector3d::Zero();
	double radius_m = 0, height_m = 0;
};

/** A named place to start from. */
struct Spawn
{
	std::string name;
	Eigen::Vector3d position_in_map = Eigen::Vector3d::Zero();
	double yaw_rad = 0;
};

/** A named list of points to drive through, in order. */
struct Route
{
	std::string name;
	std::vector<Eigen::Vector3d> points_in_map;  ///< z is the altitude of a MAV; 0 for a ground robot
};

struct World
{
	std::string name;
	std::vector<Material> materials;
	TriangleMesh mesh;                            ///< all that stands still, in the map frame
	std::vector<std::uint32_t> body_of_triangle;  ///< index into bodies, one a triangle of mesh
	std::vector<Body> bodies;
	std::vector<MovingBody> moving;
	std::vector<DoorLabel> doors;
	std::vector<CorridorLabel> corridors;
	std::vector<ObstacleLabel> obstacles;
	std::vector<Spawn> spawns;
	std::vector<Route> routes;
	std::vector<std::string> warnings;  ///< what was left out or mended when it was loaded, and why

	/** Adds `piece` (in the map frame) as a body of its own; returns the body's index. */
	std::size_t add(const std::string& body_name, const TriangleMesh& piece, std::size_t material);
	/** The index of the material of that name; makes it when there is none. */
	std::size_t materialNamed(const std::string& material_name, const Eigen::Vector3f& color = {0.7F, 0.7F, 0.7F});
};

/** The box around all bodies that stand still and are higher than 10 cm: a floor that is larger than the building would
 *  hide its size. */
Eigen::AlignedBox3f solidBounds(const World& world);

/** Moves, turns and appends `piece` to `mesh`. */
void append(TriangleMesh& mesh, const TriangleMesh& piece, const Eigen::Isometry3d& mesh_from_piece);
}  // namespace explore::simulation
