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

VerticalCylinder bodyWithMargin(const RobotConfig& robot, const Eigen::Vector3d& position_in_map, double margin_m)
{
	VerticalCylinder body = bodyAt(robot, position_in_map);
	const double below_m = robot.kind == RobotKind::ground ? 0.0 : margin_m;
	body.base.z() -= below_m;
	body.radius_m += margin_m;
	body.height_m += margin_m + below_m;
	return body;
}

double bodyClearance(const RayScene& scene, const RobotConfig& robot, const Eigen::Vector3d& position_in_map,
                     double max_m)
{
	constexpr double kExact_m = 1e-3;
	const auto touches = [&](double margin_m)
	{
		const VerticalCylinder body = bodyWithMargin(robot, position_in_map, margin_m);
		return scene.touchesCylinder(body.base, body.radius_m, body.height_m);
	};
	if (!touches(max_m)) return max_m;
	double free_m = 0.0, blocked_m = max_m;
	while (blocked_m - free_m > kExact_m)
	{
		const double middle_m = 0.5 * (free_m + blocked_m);
		(touches(middle_m) ? blocked_m : free_m) = middle_m;
	}
	return free_m;
}
}  // namespace explore::simulation
