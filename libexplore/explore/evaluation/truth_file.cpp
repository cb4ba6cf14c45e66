#include <explore/core/errors.h>
#include <explore/evaluation/json_place.h>
#include <explore/evaluation/truth_file.h>
#include <explore/sinks/output_file.h>

#include <cmath>

namespace explore::evaluation
{
namespace
{
constexpr int kSchema = 1;

/** Metres with two decimals, whole ones without any. */
Json twoDecimals(double value)
{
	const double hundredths = std::round(jsonNumber(value).get<double>() * 100.0);
	if (std::fmod(hundredths, 100.0) == 0.0) return static_cast<std::int64_t>(hundredths / 100.0);
	return hundredths / 100.0;
}

Json robotJson(const RobotConfig& robot)
{
	return {{"kind", nameOf(robot.kind)},
	        {"radius", jsonNumber(robot.radius_m)},
	        {"height", jsonNumber(robot.height_m)},
	        {"max_speed", jsonNumber(robot.max_speed_mps)},
	        {"max_acceleration", jsonNumber(robot.max_acceleration_mps2)},
	        {"max_yaw_rate", jsonNumber(robot.max_yaw_rate_radps)},
	        {"min_altitude", jsonNumber(robot.min_altitude_m)},
	        {"max_altitude", jsonNumber(robot.max_altitude_m)}};
}

Json cameraJson(const CameraIntrinsics& camera)
{
	return {{"width", camera.width_px},       {"height", camera.height_px},     {"fx", jsonNumber(camera.fx_px)},
	        {"fy", jsonNumber(camera.fy_px)}, {"cx", jsonNumber(camera.cx_px)}, {"cy", jsonNumber(camera.cy_px)}};
}

Json poseJson(const mrpt::poses::CPose3D& pose)
{
	return {{"x", jsonNumber(pose.x())},     {"y", jsonNumber(pose.y())},         {"z", jsonNumber(pose.z())},
	        {"yaw", jsonNumber(pose.yaw())}, {"pitch", jsonNumber(pose.pitch())}, {"roll", jsonNumber(pose.roll())}};
}

Json doorJson(const TruthDoor& door)
{
	return {{"id", door.id},
	        {"center", jsonVector(door.center_in_map)},
	        {"normal", jsonVector(door.normal_in_map)},
	        {"width", jsonNumber(door.width_m)},
	        {"height", jsonOrNull(door.height_m)},
	        {"clear_width", jsonNumber(door.clear_width_m)},
	        {"verdict", nameOf(door.verdict)},
	        {"passable", door.passable},
	        {"visibility", nameOf(door.visibility)},
	        {"visible_share", jsonNumber(door.visible_share)},
	        {"jamb_share", {jsonNumber(door.jamb_share[0]), jsonNumber(door.jamb_share[1])}},
	        {"lintel_in_view", door.lintel_in_view}};
}

Json corridorJson(const TruthCorridor& corridor)
{
	return {{"state", nameOf(corridor.state)},
	        {"direction", jsonVector(corridor.direction_in_map)},
	        {"width", jsonNumber(corridor.width_m)}};
}

Json obstacleJson(const TruthObstacle& obstacle)
{
	return {{"kind", obstacle.kind},
	        {"center", jsonVector(obstacle.center_in_map)},
	        {"radius", jsonNumber(obstacle.radius_m)},
	        {"height", jsonNumber(obstacle.height_m)}};
}

Json freePathsJson(const std::optional<TruthFreePaths>& paths)
{
	if (!paths) return {};
	if (paths->free_m.size() != paths->elevations_rad.size() * TruthFreePaths::kAzimuths)
		throw std::logic_error("free paths: not 360 for each elevation");
	Json elevations = Json::array(), free = Json::array();
	for (const double elevation_rad : paths->elevations_rad) elevations.push_back(jsonNumber(elevation_rad));
	for (const float free_m : paths->free_m) free.push_back(twoDecimals(free_m));
	return {{"cap", jsonNumber(paths->cap_m)}, {"elevations", elevations}, {"free", free}};
}

Json frameJson(const TruthFrame& frame)
{
	Json doors = Json::array(), obstacles = Json::array();
	for (const TruthDoor& door : frame.doors) doors.push_back(doorJson(door));
	for (const TruthObstacle& obstacle : frame.obstacles) obstacles.push_back(obstacleJson(obstacle));
	Json json = {{"index", frame.index},   {"t", jsonNumber(frame.t)},
	             {"scene", frame.scene},   {"map_from_robot", poseJson(frame.map_from_robot)},
	             {"doors", doors},         {"corridor", corridorJson(frame.corridor)},
	             {"obstacles", obstacles}, {"free_paths", freePathsJson(frame.free_paths)}};
	if (frame.robot_from_camera) json["robot_from_camera"] = poseJson(*frame.robot_from_camera);
	return json;
}

Json headerJson(const TruthLog& truth)
{
	return {{"schema", kSchema},
	        {"world", truth.world},
	        {"family", truth.family},
	        {"configuration", truth.configuration},
	        {"negative", truth.negative},
	        {"robot", robotJson(truth.robot)},
	        {"noise", truth.noise},
	        {"seed", truth.seed},
	        {"command", truth.command},
	        {"camera", cameraJson(truth.intrinsics)},
	        {"robot_from_camera", poseJson(truth.robot_from_camera)}};
}
}  // namespace

std::filesystem::path truthPathOf(const std::filesystem::path& log)
{
	return std::filesystem::path(log).replace_extension(".truth.json");
}

std::string truthText(const TruthLog& truth)
{
	std::string text = jsonText(headerJson(truth));
	text.back() = ',';  // the header's brace closes after the frames, which stand on a line each
	text += "\"frames\":[";
	for (std::size_t i = 0; i < truth.frames.size(); ++i)
		text.append(i == 0 ? "\n" : ",\n").append(jsonText(frameJson(truth.frames[i])));
	return text.append("\n]}\n");
}

void writeTruth(const std::filesystem::path& path, const TruthLog& truth)
{
	writeFileAtomically(path, truthText(truth));
}
}  // namespace explore::evaluation
