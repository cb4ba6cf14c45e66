#include "pose_track.h"

#include <explore/core/geometry.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace explore
{
bool isSane(const mrpt::poses::CPose3D& pose)
{
	constexpr double kFarthest_m = 1e6, kRotationTolerance = 1e-3;
	const Eigen::Isometry3d isometry = isometryOf(pose);
	if (!isometry.matrix().allFinite()) return false;
	const Eigen::Matrix3d rotation = isometry.linear();
	return isometry.translation().cwiseAbs().maxCoeff() < kFarthest_m &&
	       (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < kRotationTolerance;
}

mrpt::poses::CPose3D interpolate(const mrpt::poses::CPose3D& a, const mrpt::poses::CPose3D& b, double share)
{
	const Eigen::Isometry3d from = isometryOf(a), to = isometryOf(b);
	const Eigen::Quaterniond q = Eigen::Quaterniond(from.linear()).slerp(share, Eigen::Quaterniond(to.linear()));
	const Eigen::Vector3d t = (1.0 - share) * from.translation() + share * to.translation();
	mrpt::math::CMatrixDouble44 matrix = mrpt::math::CMatrixDouble44::Identity();
	const Eigen::Matrix3d rotation = q.normalized().toRotationMatrix();
	for (int row = 0; row < 3; ++row)
	{
		for (int column = 0; column < 3; ++column) matrix(row, column) = rotation(row, column);
		matrix(row, 3) = t[row];
	}
	return mrpt::poses::CPose3D(matrix);
}

std::deque<PoseTrack::Sample>::const_iterator PoseTrack::firstNotBefore(LogTime time) const
{
	return std::lower_bound(m_samples.begin(), m_samples.end(), time,
	                        [](const Sample& sample, LogTime t) { return sample.time < t; });
}

void PoseTrack::add(LogTime time, const mrpt::poses::CPose3D& map_from_robot)
{
	const auto place = firstNotBefore(time);
	if (place != m_samples.end() && place->time == time)
		m_samples[static_cast<std::size_t>(place - m_samples.begin())].pose = map_from_robot;
	else
		m_samples.insert(place, {time, map_from_robot});
}

std::optional<mrpt::poses::CPose3D> PoseTrack::at(LogTime time) const
{
	if (m_samples.empty()) return std::nullopt;
	const auto after = firstNotBefore(time);
	if (after == m_samples.end()) return m_samples.back().pose;
	if (after == m_samples.begin() || after->time == time) return after->pose;
	const auto before = std::prev(after);
	return interpolate(before->pose, after->pose,
	                   secondsBetween(before->time, time) / secondsBetween(before->time, after->time));
}

std::optional<double> PoseTrack::awayFrom(LogTime time) const
{
	if (m_samples.empty()) return std::nullopt;
	const auto after = firstNotBefore(time);
	const double infinity = std::numeric_limits<double>::infinity();
	const double before_s = after == m_samples.begin() ? infinity : secondsBetween(std::prev(after)->time, time);
	return std::min(before_s, after == m_samples.end() ? infinity : secondsBetween(time, after->time));
}

void PoseTrack::forgetBefore(LogTime time)
{
	while (m_samples.size() > 1 && m_samples[1].time <= time) m_samples.pop_front();
}
}  // namespace explore
