#include <explore/simulation/robot_body.h>

#include <algorithm>

namespace explore::simulation
{
VerticalCylinder bodyAt(const RobotConfig& robot, const Eigen::Vector3d& position_in_map)
{
	const bool ground = robot.kind == RobotKind::ground;
	const double low = ground ? std::min(kUnderbody_m, 0.5 * robot.height_m) : -0.5 * robot.height_m;
	const double height = ground ? robot.height_m - low : robot.height_m;
	return {position_in_map + Eigen::Vector3d(0.0, 0.0, low), robot.radius_m, height};
}
}  // namespace explore::simulation
