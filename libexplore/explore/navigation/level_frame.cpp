#include <explore/navigation/level_frame.h>

namespace explore
{
LevelFrame levelFrame(const std::optional<Plane>& ground, const Eigen::Vector3d& up_in_robot)
{
	const Eigen::Vector3d up = ground ? ground->normal : up_in_robot;
	const Eigen::Vector3d along = Eigen::Vector3d::UnitX() - up.x() * up;
	LevelFrame level;
	level.altitude_m = ground ? ground->d_m : 0.0;
	// A robot that looks along the floor's normal has no heading; its own axes are as good as any.
	if (along.norm() < 1e-6) return level;
	const Eigen::Vector3d forward = along.normalized();
	level.level_from_robot.row(0) = forward;
	level.level_from_robot.row(1) = up.cross(forward);
	level.level_from_robot.row(2) = up;
	return level;
}
}  // namespace explore
