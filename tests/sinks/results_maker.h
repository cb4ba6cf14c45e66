// A frame with its results, every field set to a value that can be told from the others.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/pipeline/explorer.h>

namespace explore::test
{
inline DepthFrame fullFrame()
{
	DepthFrame frame;
	frame.index = 7;
	frame.timestamp = mrpt::Clock::fromDouble(1416537600.125);
	frame.sensor_label = "KINECT";
	frame.map_from_robot = mrpt::poses::CPose3D(1.0, 2.0, 0.5, 1.5707963267948966, 0.0, 0.0);
	frame.pose_origin = PoseOrigin::odometry;
	return frame;
}

inline StepResult fullResult()
{
	StepResult result;
	result.percepts.ground = Ground{{Eigen::Vector3d(0, 0, 1), 0.01}, 0.62, 900, true};
	result.percepts.walls = {
	    Wall{{Eigen::Vector3d(0, -1, 0), 1.0}, 1234, {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 0, 0)}}};
	Door door;
	door.center = {2.0, 1.0, 1.02};
	door.normal = {0, -1, 0};
	door.width_m = 0.92;
	door.height_m = 2.04;
	door.clear_width_m = 0.9;
	door.confidence = 0.97;
	door.track = 3;
	result.percepts.doors = {door};
	result.percepts.vanishing_points = {
	    VanishingPoint{Eigen::Vector3d(5, 0, 0.5), Eigen::Vector3d(1, 0, 0), {0, 2}, 2000, 1}};
	Decision& decision = result.decision;
	decision.goal = {GoalKind::door, 3, Eigen::Vector3d(2.0, 1.0, 0.0)};
	decision.headings = {0.31, 0.02, 0.25, 0.3, 0.29, 0.0};
	decision.open_path_m = 3.4;
	decision.command = {Eigen::Vector3d(0.4, 0, 0), 0.1};
	return result;
}
}  // namespace explore::test
