#include <explore/sinks/json_lines.h>
#include <explore/sinks/json_values.h>

namespace explore
{
namespace
{
Json planeJson(const Plane& plane)
{
	Json result = jsonVector(plane.normal);
	result.push_back(jsonNumber(plane.d_m));
	return result;
}

Json poseJson(const DepthFrame& frame)
{
	const auto& pose = frame.map_from_robot;
	return {{"x", jsonNumber(pose.x())},        {"y", jsonNumber(pose.y())},         {"z", jsonNumber(pose.z())},
	        {"yaw", jsonNumber(pose.yaw())},    {"pitch", jsonNumber(pose.pitch())}, {"roll", jsonNumber(pose.roll())},
	        {"from", nameOf(frame.pose_origin)}};
}

Json groundJson(const std::optional<Ground>& ground)
{
	if (!ground) return {};
	return {{"plane", planeJson(ground->plane)},
	        {"camera_height", jsonNumber(ground->camera_height_m)},
	        {"seen", ground->seen}};
}

Json wallJson(const Wall& wall)
{
	return {{"plane", planeJson(wall.plane)},
	        {"inliers", wall.inliers},
	        {"floor_line",
	         {{"point", jsonVector(wall.floor_line.point)}, {"direction", jsonVector(wall.floor_line.direction)}}}};
}

Json doorJson(const Door& door)
{
	return {{"center", jsonVector(door.center)},         {"normal", jsonVector(door.normal)},
	        {"width", jsonNumber(door.width_m)},         {"height", jsonOrNull(door.height_m)},
	        {"verdict", nameOf(door.verdict)},           {"clear_width", jsonNumber(door.clear_width_m)},
	        {"confidence", jsonOrNull(door.confidence)}, {"track", jsonOrNull(door.track)}};
}

Json vanishingPointJson(const VanishingPoint& vanishing_point)
{
	return {{"point", jsonVector(vanishing_point.point)},
	        {"direction", jsonVector(vanishing_point.direction)},
	        {"walls", vanishing_point.walls},
	        {"track", jsonOrNull(vanishing_point.track)}};
}

template <class Items, class ToJson>
Json listJson(const Items& items, ToJson to_json)
{
	Json result = Json::array();
	for (const auto& item : items) result.push_back(to_json(item));
	return result;
}

Json headingsJson(const Headings& headings)
{
	return {{"door", jsonOrNull(headings.door_rad)},
	        {"vanishing_point", jsonOrNull(headings.vanishing_point_rad)},
	        {"avoid", jsonOrNull(headings.avoid_rad)},
	        {"desired", jsonOrNull(headings.desired_rad)},
	        {"chosen", jsonOrNull(headings.chosen_rad)}};
}

Json goalJson(const Goal& goal, const mrpt::poses::CPose3D& map_from_robot)
{
	Json point_in_map;
	if (goal.point_in_robot) point_in_map = jsonVector(isometryOf(map_from_robot) * *goal.point_in_robot);
	return {{"kind", nameOf(goal.kind)}, {"track", jsonOrNull(goal.track)}, {"point_in_map", point_in_map}};
}

Json commandJson(const Command& command)
{
	return {{"v", jsonVector(command.velocity_mps)}, {"yaw_rate", jsonNumber(command.yaw_rate_radps)}};
}
}  // namespace

std::string frameLine(const DepthFrame& frame, const StepResult& result)
{
	const Percepts& percepts = result.percepts;
	const Decision& decision = result.decision;
	const Json line{
	    {"frame", frame.index},
	    {"t", jsonNumber(mrpt::Clock::toDouble(frame.timestamp))},
	    {"sensor", frame.sensor_label},
	    {"pose", poseJson(frame)},
	    {"ground", groundJson(percepts.ground)},
	    {"walls", listJson(percepts.walls, wallJson)},
	    {"doors", listJson(percepts.doors, doorJson)},
	    {"vanishing_points", listJson(percepts.vanishing_points, vanishingPointJson)},
	    {"headings", headingsJson(decision.headings)},
	    {"chosen_elevation", jsonNumber(decision.headings.chosen_elevation_rad)},
	    {"open_path", jsonNumber(decision.open_path_m)},
	    {"stop", decision.stop},
	    {"command", commandJson(decision.command)},
	    {"goal", goalJson(decision.goal, frame.map_from_robot)},
	    {"stop_reason", decision.stop ? Json(nameOf(decision.stop_reason)) : Json()},
	};
	return jsonText(line) + '\n';
}
}  // namespace explore
