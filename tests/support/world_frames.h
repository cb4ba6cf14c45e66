// Depth frames that a simulated robot takes of a world while it drives, with their true poses.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/robot.h>

#include <string>
#include <vector>

namespace explore::test
{
struct WorldDrive
{
	std::string world, route;  ///< of rawlogs/worlds
	RobotKind kind = RobotKind::ground;
	int frames = 50;
	double period_s = 0.5;
	int width_px = 640;
};

/** Kinect noise, true poses; always the same frames for the same drive. */
std::vector<DepthFrame> worldFrames(const WorldDrive& drive);

/** Three worlds of ours: a corridor with a turn, an office, a warehouse that a MAV flies through. */
std::vector<WorldDrive> ourDrives(int frames, int width_px);
}  // namespace explore::test
