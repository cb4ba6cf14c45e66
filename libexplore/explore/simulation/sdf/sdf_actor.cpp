#include <explore/core/errors.h>
#include <explore/simulation/moving_track.h>
#include <explore/simulation/sdf/sdf_actor.h>
#include <explore/simulation/sdf/sdf_values.h>
#include <explore/simulation/shapes.h>

#include <algorithm>
#include <cmath>

namespace explore::simulation
{
namespace
{
/** Higher than any skin's root above the floor it stands on. */
constexpr double kHighestRoot_m = 1.6;

TrackPoint pointOf(const XmlNode& element, double t_s)
{
	const Eigen::Isometry3d map_from_actor = poseOf(element);
	TrackPoint point;
	point.t_s = t_s;
	point.position_in_map = map_from_actor.translation();
	point.yaw_rad = std::atan2(map_from_actor.linear()(1, 0), map_from_actor.linear()(0, 0));
	return point;
}

/** The waypoints of all trajectories, in seconds from the start of the script. */
std::vector<TrackPoint> pointsOf(const XmlNode& script)
{
	std::vector<TrackPoint> points;
	double start_s = 0;
	for (const XmlNode& trajectory : script.children)
	{
		if (trajectory.name != "trajectory") continue;
		for (const XmlNode& waypoint : trajectory.children)
			if (waypoint.name == "waypoint")
				points.push_back(pointOf(waypoint, start_s + numberAt(waypoint, "time", 0)));
		if (!points.empty()) start_s = points.back().t_s;
	}
	std::stable_sort(points.begin(), points.end(),
	                 [](const TrackPoint& a, const TrackPoint& b) { return a.t_s < b.t_s; });
	return points;
}
}  // namespace

MovingBody actorBody(const XmlNode& actor, std::size_t material, Warnings& warnings)
{
	MovingBody body;
	body.name = actor.attribute("name");
	body.kind = "person";
	body.radius_m = 0.25;
	body.mesh = personMesh(body.height_m, body.radius_m);
	body.material = material;
	std::vector<TrackPoint> points;
	if (const XmlNode* script = actor.child("script"))
	{
		points = pointsOf(*script);
		body.loop = script->child("loop") == nullptr || flagAt(*script, "loop");
	}
	if (points.empty()) points.push_back(pointOf(actor, 0));
	for (TrackPoint& point : points)
	{
		if (point.position_in_map.z() > kHighestRoot_m)
			warnings.add("actor '" + body.name + "' walks on the floor z = 0, not where its poses are");
		point.position_in_map.z() = 0;
	}
	body.track = trackThrough(points);
	return body;
}
}  // namespace explore::simulation
