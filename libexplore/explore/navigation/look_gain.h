// How much of the unknown space that the robot wants to know a look from a place would show.
#pragma once

#include <explore/navigation/plan_map.h>

#include <Eigen/Core>

namespace explore
{
/** A place in a layer and the way the camera looks. */
struct Look
{
	CellIndex cell = kNoCell;
	double yaw_rad = 0;
};

/** Area [m²] of wanted space in the camera's wedge: rays end at the view range, at what stands there, and where they
 * have passed view_depth_m of unknown space, wanted or not. */
double lookGain(const PlanMap& map, const Look& look, const PlanConfig& config);

/** Whether a point, in this layer or another, is in the look's wedge and range, with nothing but free space before it.
 */
bool sees(const PlanMap& map, const Look& look, const Eigen::Vector3d& point_in_map, const PlanConfig& config);
}  // namespace explore
