// What of one frame is drawn in 3D scenes: small enough to be kept from frame to frame.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/robot.h>
#include <explore/pipeline/explorer.h>
#include <mrpt/opengl/CSetOfObjects.h>

#include <utility>
#include <vector>

namespace explore
{
struct FrameSketch
{
	std::size_t index = 0;
	mrpt::poses::CPose3D map_from_robot;
	PoseOrigin pose_origin = PoseOrigin::none;
	PointCloud cloud_in_robot;  ///< thinned, some thousand points
	/** Where walls meet the floor, as far as the image shows it: both ends of each stretch. */
	std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> floor_lines_in_robot;
	StepResult result;  ///< without the points of obstacles
};

/** Lines are followed up to `max_range_m` either way. */
FrameSketch sketchOf(const DepthFrame& frame, const StepResult& result, double max_range_m);

/** The headings, vanishing points and the robot, robot frame. Names: `robot`, `heading.door` `.vanishing_point`
 *  `.avoid` `.chosen`, `frame.vanishing_point.N`. */
mrpt::opengl::CSetOfObjects::Ptr directionObjects(const FrameSketch& sketch, const RobotConfig& robot);
/** The same with the cloud, the doors that the frame shows, the wall–floor lines and what was decided as text:
 * `frame.cloud`, `frame.door.N`, `frame.floor_lines`, `frame.text`; N counts from 0 as in frames.jsonl. */
mrpt::opengl::CSetOfObjects::Ptr frameObjects(const FrameSketch& sketch, const RobotConfig& robot);
}  // namespace explore
