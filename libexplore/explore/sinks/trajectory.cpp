#include <explore/core/geometry.h>
#include <explore/sinks/trajectory.h>
#include <mrpt/core/format.h>

namespace explore
{
std::string trajectoryLine(const DepthFrame& frame)
{
	const Eigen::Isometry3d map_from_robot = isometryOf(frame.map_from_robot);
	Eigen::Quaterniond q(map_from_robot.linear());
	q.normalize();
	if (q.w() < 0.0) q.coeffs() = -q.coeffs();
	const auto& p = map_from_robot.translation();
	return mrpt::format("%.6f %.6f %.6f %.6f %.9f %.9f %.9f %.9f\n", mrpt::Clock::toDouble(frame.timestamp), p.x(),
	                    p.y(), p.z(), q.x(), q.y(), q.z(), q.w());
}
}  // namespace explore
