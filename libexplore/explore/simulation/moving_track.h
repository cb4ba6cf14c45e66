// Tracks of moving bodies from the few points that their author gives.
#pragma once

#include <explore/simulation/world.h>

#include <optional>
#include <vector>

namespace explore::simulation
{
struct TrackPoint
{
	double t_s = 0;
	Eigen::Vector3d position_in_map = Eigen::Vector3d::Zero();
	std::optional<double> yaw_rad;  ///< no value: looks where it goes
};

/** The track through `points` (by time). A body without a yaw of its own turns within the last 0.4 s before each
 * corner; yaws are continued beyond ±π so that linear interpolation never turns the long way round. */
std::vector<Waypoint> trackThrough(const std::vector<TrackPoint>& points);
}  // namespace explore::simulation
