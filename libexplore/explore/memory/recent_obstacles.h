// What stood near the robot a moment ago and may have got into its blind zone since: people come too near to be
// measured before the map believes them.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/core/point_cloud.h>
#include <explore/core/robot.h>
#include <explore/memory/body_layers.h>

#include <array>
#include <map>

namespace explore
{
/** A point that was measured, or lies within what was, and when. */
struct RecentObstacle
{
	Eigen::Vector3d place_in_map = Eigen::Vector3d::Zero();
	double seen_at_s = 0;
};

struct RecentObstacles
{
	std::map<std::array<int, 3>, RecentObstacle>
	    cells;  ///< the last of each cell of 5 cm; of each column on the ground
};

/** Adds the obstacle points of a frame that are within 1.2 m of the robot. One that stands where `layers` know free
 *  space has come lately: only its front is seen, and 0.3 m behind are taken for its body. Forgets what the frame sees
 *  through, and what was last seen 10 s ago: by then a map's voxels say what stays, and who walks is elsewhere. An
 *  unorganised cloud sees through nothing. */
void update(RecentObstacles& recent, const DepthFrame& frame, const PointCloud& obstacles_in_robot,
            const BodyLayers& layers, const RobotConfig& robot);

/** All that is remembered, robot frame. */
PointCloud inRobotFrame(const RecentObstacles& recent, const Eigen::Isometry3d& map_from_robot);
}  // namespace explore
