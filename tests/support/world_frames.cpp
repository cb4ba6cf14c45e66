#include "world_frames.h"

#include <explore/simulation/depth_camera.h>
#include <explore/simulation/load_world.h>
#include <explore/simulation/recorder.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace explore::test
{
std::vector<DepthFrame> worldFrames(const WorldDrive& drive)
{
	constexpr std::uint64_t kSeed = 1;
	const auto folder = std::filesystem::path(EXPLORE_SOURCE_DIR) / "rawlogs" / "worlds";
	const simulation::World world = simulation::loadWorld(folder / (drive.world + ".sdf"), {});
	const auto route = std::ranges::find(world.routes, drive.route, &simulation::Route::name);
	if (route == world.routes.end()) throw std::out_of_range(drive.world + " has no route " + drive.route);
	RobotConfig robot;
	robot.kind = drive.kind;
	simulation::RayScene scene(world);
	const auto carrier = simulation::carrierOnRoute(scene, robot, {}, *route, kSeed);
	const simulation::DepthCameraConfig camera = simulation::depthCamera("xtion", drive.width_px);
	std::vector<DepthFrame> frames(static_cast<std::size_t>(drive.frames));
	for (std::size_t i = 0; i < frames.size(); ++i)
	{
		DepthFrame& frame = frames[i];
		const double t_s = drive.period_s * static_cast<double>(i);
		carrier->advanceTo(t_s);
		frame.index = i;
		frame.timestamp += std::chrono::milliseconds(static_cast<int>(1000.0 * t_s));
		frame.robot_from_camera = simulation::usualMount(drive.kind);
		frame.map_from_robot = carrier->truePose();
		frame.pose_origin = PoseOrigin::robot_pose;
		const Eigen::Isometry3d map_from_camera = isometryOf(frame.map_from_robot + frame.robot_from_camera);
		frame.image = simulation::takeShot(scene, camera, map_from_camera, kSeed + i).depth;
	}
	return frames;
}

std::vector<WorldDrive> ourDrives(int frames, int width_px)
{
	return {
	    {.world = "corridor", .route = "main", .frames = frames, .width_px = width_px},
	    {.world = "office", .route = "north", .frames = frames, .width_px = width_px},
	    {.world = "warehouse", .route = "mav_aisles", .kind = RobotKind::mav, .frames = frames, .width_px = width_px}};
}
}  // namespace explore::test
