#include "room_frames.h"

#include <explore/core/geometry.h>
#include <explore/simulation/depth_camera.h>
#include <explore/simulation/scenes/scene.h>

#include <chrono>

namespace explore::test
{
namespace
{
constexpr double kStart_s = 1'500'000'000.0, kBetweenScenes_s = 20.0;

DepthFrame frameOf(const simulation::Scene& scene, const simulation::SceneLook& look,
                   const simulation::DepthCameraConfig& camera, std::uint64_t seed)
{
	DepthFrame frame;
	frame.sensor_label = "XTION";
	frame.map_from_robot = look.truth.map_from_robot;
	frame.robot_from_camera = look.truth.robot_from_camera.value();
	frame.pose_origin = PoseOrigin::odometry;
	const Eigen::Isometry3d map_from_robot = isometryOf(frame.map_from_robot);
	frame.up_in_robot = map_from_robot.linear().transpose() * Eigen::Vector3d::UnitZ();
	frame.image = takeShot(*scene.rays, camera, map_from_robot * isometryOf(frame.robot_from_camera), seed).depth;
	return frame;
}
}  // namespace

std::vector<DepthFrame> roomFrames()
{
	const simulation::DepthCameraConfig camera = simulation::depthCamera("xtion", 640);
	simulation::SceneRequest request;
	request.seed = 1;
	request.looks = 2;
	request.intrinsics = camera.intrinsics;
	std::vector<DepthFrame> frames;
	double scene_s = kStart_s;
	for (const simulation::SceneFamily& family : simulation::sceneFamilies())
	{
		const simulation::Scene scene = makeScene(family, request);
		for (const simulation::SceneLook& look : scene.looks)
		{
			frames.push_back(frameOf(scene, look, camera, frames.size()));
			frames.back().index = frames.size() - 1;
			frames.back().timestamp = mrpt::Clock::fromDouble(scene_s + look.t_s);
		}
		scene_s += kBetweenScenes_s;
	}
	return frames;
}
}  // namespace explore::test
