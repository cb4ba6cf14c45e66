#include <explore-rawlog/world_info.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

namespace explore::app
{
using simulation::Surface;
using simulation::World;
namespace
{
std::string nameOf(Surface surface)
{
	switch (surface)
	{
		case Surface::black:
			return "black";
		case Surface::glass:
			return "glass";
		case Surface::mirror:
			return "mirror";
		case Surface::matte:
			break;
	}
	return "matte";
}

double degreesOf(double angle_rad)
{
	return mrpt::RAD2DEG(angle_rad) + 0.0;
}

void writePlace(std::ostream& out, const Eigen::Vector3d& place)
{
	out << place.x() << ' ' << place.y() << ' ' << place.z();
}

void writeBounds(std::ostream& out, const World& world)
{
	Eigen::AlignedBox3f all;
	for (const auto& triangle : world.mesh.triangles)
		for (const std::uint32_t corner : triangle) all.extend(world.mesh.vertices[corner]);
	const auto write = [&out](const char* what, const Eigen::AlignedBox3f& box)
	{
		if (box.isEmpty()) return;
		out << what << box.min().x() << " … " << box.max().x() << ", " << box.min().y() << " … " << box.max().y()
		    << ", " << box.min().z() << " … " << box.max().z() << " m\n";
	};
	write("bounds:        ", all);
	write("without floor: ", simulation::solidBounds(world));
}

void writeMaterials(std::ostream& out, const World& world)
{
	std::map<std::pair<Surface, std::string>, std::size_t> triangles;
	for (const std::uint32_t body : world.body_of_triangle)
	{
		const simulation::Material& material = world.materials[world.bodies[body].material];
		++triangles[{material.surface, material.name}];
	}
	out << "materials:     " << triangles.size() << '\n';
	for (const auto& [material, count] : triangles)
		out << "  " << nameOf(material.first) << " '" << material.second << "': " << count << " triangles\n";
}

void writeMoving(std::ostream& out, const World& world)
{
	out << "moving:        " << world.moving.size() << '\n';
	for (const simulation::MovingBody& body : world.moving)
		out << "  " << body.kind << " '" << body.name << "': " << body.track.size() << " waypoints, "
		    << body.track.back().t_s << " s" << (body.loop ? ", again and again" : "") << '\n';
}

void writeDoors(std::ostream& out, const World& world)
{
	out << "doors:         " << world.doors.size() << '\n';
	for (const simulation::DoorLabel& door : world.doors)
	{
		out << "  '" << door.id << "' " << explore::nameOf(door.verdict) << " at ";
		writePlace(out, door.floor_center_in_map);
		out << ", width " << door.width_m << " (clear " << door.clear_width_m << ")";
		if (door.height_m) out << ", height " << *door.height_m;
		if (door.sill_m > 0) out << ", sill " << door.sill_m;
		out << ", wall " << door.depth_m << " m\n";
	}
}

void writeLabels(std::ostream& out, const World& world)
{
	out << "corridors:     " << world.corridors.size() << '\n';
	for (const simulation::CorridorLabel& corridor : world.corridors)
		out << "  '" << corridor.id << "' " << (corridor.end_in_map - corridor.start_in_map).norm() << " m long, "
		    << corridor.width_m << " m wide\n";
	std::map<std::string, std::size_t> kinds;
	for (const simulation::ObstacleLabel& obstacle : world.obstacles) ++kinds[obstacle.kind];
	out << "obstacles:     " << world.obstacles.size() << '\n';
	for (const auto& [kind, count] : kinds) out << "  " << kind << ": " << count << '\n';
	out << "spawns:        " << world.spawns.size() << '\n';
	for (const simulation::Spawn& spawn : world.spawns)
	{
		out << "  '" << spawn.name << "' at ";
		writePlace(out, spawn.position_in_map);
		out << ", yaw " << degreesOf(spawn.yaw_rad) << " deg\n";
	}
	out << "routes:        " << world.routes.size() << '\n';
	for (const simulation::Route& route : world.routes)
	{
		double length_m = 0;
		for (std::size_t i = 1; i < route.points_in_map.size(); ++i)
			length_m += (route.points_in_map[i] - route.points_in_map[i - 1]).norm();
		out << "  '" << route.name << "' " << route.points_in_map.size() << " points, " << length_m << " m\n";
	}
}
}  // namespace

std::string textOf(const World& world)
{
	std::ostringstream out;
	out << std::setprecision(6);
	out << "world:         " << world.name << '\n';
	std::set<std::string> models;
	for (const simulation::Body& body : world.bodies) models.insert(body.name.substr(0, body.name.find("::")));
	out << "models:        " << models.size() << ", in " << world.bodies.size() << " bodies\n";
	out << "triangles:     " << world.mesh.triangles.size() << '\n';
	writeBounds(out, world);
	writeMaterials(out, world);
	writeMoving(out, world);
	writeDoors(out, world);
	writeLabels(out, world);
	out << "warnings:      " << (world.warnings.empty() ? "none" : std::to_string(world.warnings.size())) << '\n';
	for (const std::string& warning : world.warnings) out << "  " << warning << '\n';
	return out.str();
}
}  // namespace explore::app
