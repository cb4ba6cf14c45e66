#include <explore/simulation/moving_track.h>
#include <explore/simulation/sdf/label_attributes.h>
#include <explore/simulation/sdf/world_labels.h>
#include <explore/simulation/shapes.h>

#include <algorithm>
#include <cmath>

namespace explore::simulation
{
namespace
{
Verdict verdictOf(LabelAttributes& label)
{
	const std::string name = label.text("verdict", "open");
	std::string accepted;
	for (int i = 0; i <= static_cast<int>(Verdict::unknown); ++i)
	{
		const auto verdict = static_cast<Verdict>(i);
		if (nameOf(verdict) == name) return verdict;
		accepted.append(accepted.empty() ? "" : ", ").append(nameOf(verdict));
	}
	label.refuse("verdict", "one of " + accepted);
}

/** Refuses a second thing of the same name. */
template <class Things, class NameOf>
void demandNew(const LabelAttributes& label, const char* attribute, const Things& things, const NameOf& name_of,
               const std::string& name)
{
	if (std::any_of(things.begin(), things.end(), [&](const auto& thing) { return name_of(thing) == name; }))
		label.refuse(attribute, "a name that is not taken yet");
}

void addDoor(World& world, LabelAttributes& label)
{
	DoorLabel door;
	door.id = label.text("id");
	demandNew(
	    label, "id", world.doors, [](const DoorLabel& other) { return other.id; }, door.id);
	door.floor_center_in_map = label.point("at");
	const double yaw_rad = label.number("yaw", {-7, 7});
	door.normal_in_map = Eigen::Vector3d(std::cos(yaw_rad), std::sin(yaw_rad), 0);
	door.width_m = label.number("width", {0.05, 50});
	if (label.has("height")) door.height_m = label.number("height", {0.2, 20});
	door.depth_m = label.number("depth", {0.001, 5}, door.depth_m);
	door.verdict = verdictOf(label);
	const bool shut = door.verdict == Verdict::closed || door.verdict == Verdict::blocked;
	door.clear_width_m = label.number("clear_width", {0, door.width_m}, shut ? 0 : door.width_m);
	door.sill_m = label.number("sill", {0, 5}, 0);
	world.doors.push_back(door);
}

void addCorridor(World& world, LabelAttributes& label)
{
	CorridorLabel corridor;
	corridor.id = label.text("id");
	demandNew(
	    label, "id", world.corridors, [](const CorridorLabel& other) { return other.id; }, corridor.id);
	corridor.start_in_map = label.point("from").head<2>();
	corridor.end_in_map = label.point("to").head<2>();
	if ((corridor.end_in_map - corridor.start_in_map).norm() < 0.1)
		label.refuse("to", "a place at least 0.1 m from the corridor's other end");
	corridor.width_m = label.number("width", {0.3, 50});
	world.corridors.push_back(corridor);
}

void addObstacle(World& world, LabelAttributes& label)
{
	ObstacleLabel obstacle;
	obstacle.kind = label.text("kind");
	obstacle.floor_center_in_map = label.point("at");
	obstacle.radius_m = label.number("radius", {0.005, 50});
	obstacle.height_m = label.number("height", {0.005, 50});
	world.obstacles.push_back(obstacle);
}

void addSpawn(World& world, LabelAttributes& label)
{
	Spawn spawn;
	spawn.name = label.text("name");
	demandNew(
	    label, "name", world.spawns, [](const Spawn& other) { return other.name; }, spawn.name);
	spawn.position_in_map = label.point("at");
	spawn.yaw_rad = label.number("yaw", {-7, 7}, 0);
	world.spawns.push_back(spawn);
}

void addRoute(World& world, LabelAttributes& label)
{
	Route route;
	route.name = label.text("name");
	demandNew(
	    label, "name", world.routes, [](const Route& other) { return other.name; }, route.name);
	route.points_in_map = label.points("points");
	if (route.points_in_map.size() < 2) label.refuse("points", "two or more points 'x y [z]' with ';' between them");
	world.routes.push_back(route);
}

TriangleMesh movingMesh(const MovingBody& body, LabelAttributes& label)
{
	if (body.kind == "person") return personMesh(body.height_m, body.radius_m);
	TriangleMesh mesh;
	const Eigen::Isometry3d lifted(Eigen::Translation3d(0, 0, body.height_m / 2));
	if (body.kind == "cylinder")
		append(mesh, cylinderMesh(body.radius_m, body.height_m), lifted);
	else if (body.kind == "box")
	{
		const double side_m = std::sqrt(2.0) * body.radius_m;  // the circle of that radius is around it
		append(mesh, boxMesh({side_m, side_m, body.height_m}), lifted);
	}
	else
		label.refuse("kind", "person, box or cylinder");
	return mesh;
}

void addMoving(World& world, LabelAttributes& label, const XmlNode& element)
{
	MovingBody body;
	body.name = label.text("name");
	demandNew(
	    label, "name", world.moving, [](const MovingBody& other) { return other.name; }, body.name);
	body.kind = label.text("kind", "person");
	body.radius_m = label.number("radius", {0.02, 5}, 0.25);
	body.height_m = label.number("height", {0.02, 10}, body.kind == "person" ? 1.75 : 1.0);
	body.gap_m = label.number("gap", {0, 10}, body.gap_m);
	body.loop = label.flag("loop", true);
	body.material = world.materialNamed(label.text("material", body.kind));
	body.mesh = movingMesh(body, label);
	std::vector<TrackPoint> points;
	for (const XmlNode& child : element.children)
	{
		LabelAttributes waypoint(child, label.file());
		if (child.name != "waypoint") waypoint.refuseElement("<waypoint> is the only element in <moving>");
		TrackPoint point;
		point.t_s = waypoint.number("t", {0, 1e6});
		point.position_in_map = waypoint.point("at");
		if (waypoint.has("yaw")) point.yaw_rad = waypoint.number("yaw", {-1000, 1000});
		waypoint.finish();
		if (!points.empty() && point.t_s <= points.back().t_s)
			waypoint.refuse("t", "more than that of the waypoint before");
		points.push_back(point);
	}
	if (points.empty()) label.refuseElement(R"(at least one <waypoint t="0" at="x y"/> is needed)");
	body.track = trackThrough(points);
	world.moving.push_back(std::move(body));
}
}  // namespace

bool holdsLabels(const XmlNode& plugin)
{
	return plugin.name == "plugin" && plugin.attribute("name") == "explore_labels";
}

void addLabels(World& world, const XmlNode& labels, const std::string& file)
{
	for (const XmlNode& element : labels.children)
	{
		LabelAttributes label(element, file);
		if (element.name == "door")
			addDoor(world, label);
		else if (element.name == "corridor")
			addCorridor(world, label);
		else if (element.name == "obstacle")
			addObstacle(world, label);
		else if (element.name == "spawn")
			addSpawn(world, label);
		else if (element.name == "route")
			addRoute(world, label);
		else if (element.name == "moving")
			addMoving(world, label, element);
		else
			label.refuseElement("not known; door, corridor, obstacle, spawn, route and moving are labels");
		label.finish();
	}
}
}  // namespace explore::simulation
