#include <explore/evaluation/json_place.h>
#include <explore/evaluation/truth_file.h>

#include <array>
#include <climits>
#include <cmath>

namespace explore::evaluation
{
namespace
{
constexpr NumberRange kLength{0.0, 1e4}, kPositive{1e-6, 1e4}, kShare{0.0, 1.0}, kPlace{-1e6, 1e6}, kAngle{-10.0, 10.0};
constexpr std::array kRobotChoices{RobotKind::ground, RobotKind::mav};
constexpr std::array kVerdictChoices{Verdict::open,    Verdict::ajar, Verdict::closed,  Verdict::blocked,
                                     Verdict::passage, Verdict::drop, Verdict::partial, Verdict::unknown};
constexpr std::array kVisibilities{Visibility::visible, Visibility::ignored, Visibility::hidden};
constexpr std::array kCorridorStates{CorridorState::none, CorridorState::not_scored, CorridorState::corridor};

template <class Enum, std::size_t N>
Enum choiceOf(const JsonPlace& place, const std::array<Enum, N>& values)
{
	return place.choice(std::span<const Enum>(values));
}

int integerOf(const JsonPlace& place)
{
	return static_cast<int>(place.count(INT_MAX));
}

RobotConfig robotOf(const JsonPlace& place)
{
	return {choiceOf(place.at("kind"), kRobotChoices),      place.at("radius").number(kPositive),
	        place.at("height").number(kPositive),           place.at("max_speed").number(kPositive),
	        place.at("max_acceleration").number(kPositive), place.at("max_yaw_rate").number(kPositive),
	        place.at("min_altitude").number(kLength),       place.at("max_altitude").number(kLength)};
}

CameraIntrinsics cameraOf(const JsonPlace& place)
{
	return {integerOf(place.at("width")),       integerOf(place.at("height")),      place.at("fx").number({1e-6, 1e6}),
	        place.at("fy").number({1e-6, 1e6}), place.at("cx").number({-1e6, 1e6}), place.at("cy").number({-1e6, 1e6})};
}

mrpt::poses::CPose3D poseOf(const JsonPlace& place)
{
	return {place.at("x").number(kPlace),   place.at("y").number(kPlace),     place.at("z").number(kPlace),
	        place.at("yaw").number(kAngle), place.at("pitch").number(kAngle), place.at("roll").number(kAngle)};
}

Eigen::Vector3d pointOf(const JsonPlace& place)
{
	const auto values = place.numbers(3, kPlace);
	return {values[0], values[1], values[2]};
}

Eigen::Vector3d unitOf(const JsonPlace& place)
{
	Eigen::Vector3d value = place.vector();
	if (!(std::abs(value.norm() - 1.0) < 1e-6)) place.refuse("a vector of length 1");
	return value;
}

TruthDoor doorOf(const JsonPlace& place)
{
	TruthDoor door;
	door.id = place.at("id").text();
	door.center_in_map = pointOf(place.at("center"));
	door.normal_in_map = unitOf(place.at("normal"));
	door.width_m = place.at("width").number(kPositive);
	if (const auto height = place.at("height"); !height.isNull()) door.height_m = height.number(kPositive);
	door.clear_width_m = place.at("clear_width").number(kLength);
	door.verdict = choiceOf(place.at("verdict"), kVerdictChoices);
	door.passable = place.at("passable").boolean();
	door.visibility = choiceOf(place.at("visibility"), kVisibilities);
	door.visible_share = place.at("visible_share").number(kShare);
	const auto jambs = place.at("jamb_share").numbers(2, kShare);
	door.jamb_share[0] = jambs[0];
	door.jamb_share[1] = jambs[1];
	door.lintel_in_view = place.at("lintel_in_view").boolean();
	return door;
}

TruthCorridor corridorOf(const JsonPlace& place)
{
	return {choiceOf(place.at("state"), kCorridorStates), unitOf(place.at("direction")),
	        place.at("width").number(kLength)};
}

TruthObstacle obstacleOf(const JsonPlace& place)
{
	return {place.at("kind").text(), pointOf(place.at("center")), place.at("radius").number(kLength),
	        place.at("height").number(kLength)};
}

std::optional<TruthFreePaths> freePathsOf(const JsonPlace& place)
{
	if (place.isNull()) return std::nullopt;
	TruthFreePaths paths;
	paths.cap_m = place.at("cap").number(kPositive);
	paths.elevations_rad = place.at("elevations").numbers(kAngle);
	if (paths.elevations_rad.empty()) place.at("elevations").refuse("at least one elevation");
	const std::size_t count = paths.elevations_rad.size() * TruthFreePaths::kAzimuths;
	constexpr double kRounding_m = 0.005;
	for (const double free_m : place.at("free").numbers(count, {0.0, paths.cap_m + kRounding_m}))
		paths.free_m.push_back(static_cast<float>(free_m));
	return paths;
}

TruthFrame frameOf(const JsonPlace& place)
{
	TruthFrame frame;
	frame.index = place.at("index").count();
	frame.t = place.at("t").number({0.0, 1e12});
	frame.scene = integerOf(place.at("scene"));
	frame.map_from_robot = poseOf(place.at("map_from_robot"));
	if (place.has("robot_from_camera")) frame.robot_from_camera = poseOf(place.at("robot_from_camera"));
	for (const JsonPlace& door : place.at("doors").items()) frame.doors.push_back(doorOf(door));
	frame.corridor = corridorOf(place.at("corridor"));
	for (const JsonPlace& obstacle : place.at("obstacles").items()) frame.obstacles.push_back(obstacleOf(obstacle));
	frame.free_paths = freePathsOf(place.at("free_paths"));
	return frame;
}

std::vector<TruthFrame> framesOf(const JsonPlace& place)
{
	std::vector<TruthFrame> frames;
	for (const JsonPlace& item : place.items())
	{
		frames.push_back(frameOf(item));
		if (frames.size() < 2) continue;
		const TruthFrame& before = frames[frames.size() - 2];
		if (frames.back().index <= before.index) item.at("index").refuse("more than that of the frame before");
		if (!(frames.back().t > before.t)) item.at("t").refuse("a later time than that of the frame before");
		if (frames.back().scene < before.scene) item.at("scene").refuse("not less than that of the frame before");
	}
	return frames;
}
}  // namespace

TruthLog readTruth(const std::filesystem::path& path)
{
	const Json document = readJson(path);
	const JsonPlace place(document, path.string());
	if (place.at("schema").count() != 1) place.at("schema").refuse("1");
	TruthLog truth;
	truth.world = place.at("world").text();
	truth.family = place.at("family").text();
	truth.configuration = place.at("configuration").text();
	truth.negative = place.at("negative").boolean();
	truth.robot = robotOf(place.at("robot"));
	truth.noise = place.at("noise").text();
	truth.seed = place.at("seed").count();
	truth.command = place.at("command").text();
	truth.intrinsics = cameraOf(place.at("camera"));
	truth.robot_from_camera = poseOf(place.at("robot_from_camera"));
	truth.frames = framesOf(place.at("frames"));
	return truth;
}
}  // namespace explore::evaluation
