#include "corridor_frames.h"

#include <numbers>

namespace explore::test
{
namespace
{
const std::vector<double> kLeftDoors{2.6, 5.6}, kRightDoors{4.0, 7.2};
constexpr double kLength_m = 14.0;
}  // namespace

std::vector<CorridorDoor> corridorDoors()
{
	std::vector<CorridorDoor> doors;
	for (const double x : kLeftDoors) doors.push_back({x + 0.5 * kCorridorDoorWidth_m, 1.0});
	for (const double x : kRightDoors) doors.push_back({x + 0.5 * kCorridorDoorWidth_m, -1.0});
	return doors;
}

std::vector<DepthFrame> corridorFrames(const CameraNoise& noise)
{
	const Scene scene = corridorScene(kLength_m, kLeftDoors, kRightDoors);
	const mrpt::poses::CPose3D robot_from_camera(0.0, 0.0, 0.6, 0.0, 0.0, 0.0);
	std::vector<DepthFrame> frames;
	for (double x = 0.0; x <= 5.0; x += 1.0)
		for (const double yaw_deg : {-30.0, 0.0, 20.0, 40.0})
		{
			CameraNoise own = noise;
			own.seed = noise.seed + static_cast<std::uint32_t>(frames.size());
			const double yaw_rad = yaw_deg * std::numbers::pi / 180.0;
			const mrpt::poses::CPose3D map_from_robot(x, 0.0, 0.0, yaw_rad, 0.0, 0.0);
			frames.push_back(renderFrame(scene, map_from_robot, robot_from_camera, xtionIntrinsics(), own));
			frames.back().index = frames.size() - 1;
			frames.back().timestamp += std::chrono::milliseconds(33 * frames.size());
		}
	return frames;
}
}  // namespace explore::test
