#include "apps/eval_fixture.h"

#include "apps/rawlog_maker.h"

#include <explore/evaluation/truth_file.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace explore::test
{
namespace
{
const mrpt::poses::CPose3D kRobotFromCamera(0.1, 0, 0.7, 0, 0, 0);
constexpr double kDoorHeight_m = 2.0, kRadius_m = 0.22, kRoomDepth_m = 3.0, kHalfRoom_m = 4.0;

Scene sceneOf(const DoorScene& shape)
{
	Scene scene;
	scene.floor(-2, -kHalfRoom_m, shape.wall_x_m + kRoomDepth_m, kHalfRoom_m);
	std::vector<Opening> openings;
	if (shape.door_width_m > 0)
		openings.push_back(
		    {kHalfRoom_m + shape.door_y_m - 0.5 * shape.door_width_m, shape.door_width_m, kDoorHeight_m});
	scene.wall({shape.wall_x_m, -kHalfRoom_m}, {shape.wall_x_m, kHalfRoom_m}, 2.6, openings);
	const double end_m = shape.wall_x_m + kRoomDepth_m;
	scene.wall({end_m, -kHalfRoom_m}, {end_m, kHalfRoom_m}, 2.6);
	if (shape.boxed_at_x_m > 0) scene.box({shape.boxed_at_x_m, 0, 0.4}, {0.3, 0.5, 0.8});
	return scene;
}

TruthDoor doorOf(const DoorScene& shape)
{
	TruthDoor door;
	door.id = "door";
	door.center_in_map = {shape.wall_x_m, shape.door_y_m, 0.5 * kDoorHeight_m};
	door.normal_in_map = -Eigen::Vector3d::UnitX();
	door.width_m = door.clear_width_m = shape.door_width_m;
	door.height_m = kDoorHeight_m;
	door.visibility = Visibility::visible;
	door.visible_share = door.jamb_share[0] = door.jamb_share[1] = 1.0;
	return door;
}

/** Free way of a disc along an azimuth: to the wall, or through the door to the wall behind, as far as the middle of
 * the disc passes between the jambs with the radius to spare. */
double freePath(const DoorScene& shape, double azimuth_rad)
{
	const double along_x = std::cos(azimuth_rad);
	if (along_x < 0.05) return 1.5;
	const double y_at_wall = shape.wall_x_m * std::tan(azimuth_rad);
	const bool passes = std::abs(y_at_wall - shape.door_y_m) < 0.5 * shape.door_width_m - 1.2 * kRadius_m;
	const double wall_x_m = shape.wall_x_m + (passes ? kRoomDepth_m : 0.0);
	double free_m = std::max(0.0, (wall_x_m - kRadius_m) / along_x);
	if (shape.boxed_at_x_m > 0 && std::abs(shape.boxed_at_x_m * std::tan(azimuth_rad)) < 0.25 + kRadius_m)
		free_m = std::min(free_m, std::max(0.0, shape.boxed_at_x_m - 0.15 - kRadius_m));
	return std::min(free_m, 8.0);
}

TruthFrame frameOf(const DoorScene& shape)
{
	TruthFrame frame;
	if (shape.door_width_m > 0 && shape.labelled) frame.doors.push_back(doorOf(shape));
	frame.free_paths.emplace();
	frame.free_paths->elevations_rad = {0.0};
	for (int degree = 0; degree < TruthFreePaths::kAzimuths; ++degree)
		frame.free_paths->free_m.push_back(static_cast<float>(freePath(shape, degree * std::numbers::pi / 180.0)));
	if (shape.boxed_at_x_m > 0) frame.obstacles.push_back({"box", {shape.boxed_at_x_m, 0, 0}, 0.29, 0.8});
	return frame;
}
}  // namespace

TruthLog headOf(const std::string& family, const std::string& configuration, bool negative)
{
	TruthLog head;
	head.world = "synth";
	head.family = family;
	head.configuration = configuration;
	head.negative = negative;
	head.noise = "none";
	head.command = "made by a test";
	head.intrinsics = xtionIntrinsics(160, 120);
	head.robot_from_camera = kRobotFromCamera;
	return head;
}

std::filesystem::path writeScoredLog(const std::filesystem::path& folder, const std::string& name,
                                     const std::vector<DoorScene>& scenes, const TruthLog& head)
{
	TruthLog truth = head;
	std::vector<DepthFrame> frames;
	for (std::size_t i = 0; i < scenes.size(); ++i)
	{
		DepthFrame frame = renderFrame(sceneOf(scenes[i]), {}, kRobotFromCamera, head.intrinsics);
		frame.index = i;
		frame.timestamp = mrpt::Clock::fromDouble(1'500'000'000.0 + 20.0 * static_cast<double>(i));
		TruthFrame truth_frame = frameOf(scenes[i]);
		truth_frame.index = i;
		truth_frame.scene = static_cast<int>(i);
		truth_frame.t = mrpt::Clock::toDouble(frame.timestamp);
		frames.push_back(std::move(frame));
		truth.frames.push_back(std::move(truth_frame));
	}
	auto log = folder / (name + ".rawlog");
	writeRawlog(log, frames);
	evaluation::writeTruth(evaluation::truthPathOf(log), truth);
	return log;
}

ProgramResult exploreEval(std::vector<std::string> arguments, const Program::Setup& setup)
{
	if (!arguments.empty() && arguments[0].ends_with(".rawlog"))
		arguments.insert(arguments.end(), {"--set", "perception.method=paper"});
	return Program(EXPLORE_EVAL_PROGRAM, arguments, setup).wait();
}
}  // namespace explore::test
