#include <explore/core/geometry.h>
#include <explore/sinks/trajectory.h>
#include <mrpt/core/format.h>

namespace explore
{
std::string trajectoryLine(mrpt::Clock::time_point time, const mrpt::poses::CPose3D& map_from_robot)
{
	const Eigen::Isometry3d pose = isometryOf(map_from_robot);
	Eigen::Quaterniond q(pose.linear());
	q.normalize();
	if (q.w() < 0.0) q.coeffs() = -q.coeffs();
	const auto& p = pose.translation();
	return mrpt::format("%.6f %.6f %.6f %.6f %.9f %.9f %.9f %.9f\n", mrpt::Clock::toDouble(time), p.x(), p.y(), p.z(),
	                    q.x(), q.y(), q.z(), q.w());
}

std::string trajectoryLine(const DepthFrame& frame)
{
	return trajectoryLine(frame.timestamp, frame.map_from_robot);
}
}  // namespace explore
