#include <explore/core/geometry.h>
#include <explore/simulation/free_paths.h>
#include <explore/simulation/robot_body.h>
#include <explore/simulation/swept_body.h>

#include <cmath>

namespace explore::simulation
{
namespace
{
}  // namespace

TruthFreePaths freePaths(const RayScene& scene, const RobotConfig& robot, const mrpt::poses::CPose3D& map_from_robot)
{
	TruthFreePaths paths;
	const int tilts = robot.kind == RobotKind::mav ? 3 : 0;
	for (int i = -tilts; i <= tilts; ++i) paths.elevations_rad.push_back(10.0 * i * kDegree_rad);

	const Eigen::Vector3d position(map_from_robot.x(), map_from_robot.y(), map_from_robot.z());
	const SweptBody body(scene, bodyAt(robot, position), paths.cap_m, paths.elevations_rad.back());
	paths.free_m.reserve(paths.elevations_rad.size() * TruthFreePaths::kAzimuths);
	for (const double elevation : paths.elevations_rad)
		for (int i = 0; i < TruthFreePaths::kAzimuths; ++i)
			paths.free_m.push_back(
			    static_cast<float>(body.freePath(map_from_robot.yaw() + i * kDegree_rad, elevation)));
	return paths;
}
}  // namespace explore::simulation
