#include "gravity_track.h"

#include <explore/core/geometry.h>
#include <explore/sources/pose_track.h>
#include <mrpt/obs/CObservationIMU.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
using mrpt::obs::CObservationIMU;

std::optional<Eigen::Vector3d> accelerationInRobot(const CObservationIMU& imu)
{
	using namespace mrpt::obs;
	if (!imu.has(IMU_X_ACC) || !imu.has(IMU_Y_ACC) || !imu.has(IMU_Z_ACC)) return std::nullopt;
	const Eigen::Vector3d in_imu(imu.get(IMU_X_ACC), imu.get(IMU_Y_ACC), imu.get(IMU_Z_ACC));
	if (!in_imu.allFinite() || !isSane(imu.sensorPose)) return std::nullopt;
	return isometryOf(imu.sensorPose).linear() * in_imu;
}
}  // namespace

bool GravityTrack::add(const mrpt::obs::CObservation& observation, WarnOnce& warn)
{
	const auto* imu = dynamic_cast<const CObservationIMU*>(&observation);
	if (imu == nullptr) return false;
	const auto acceleration = accelerationInRobot(*imu);
	if (!acceleration || !isUsable(imu->timestamp)) return true;
	if (!m_label) m_label = imu->sensorLabel;
	if (*m_label != imu->sensorLabel)
		warn("imu label " + imu->sensorLabel,
		     "several IMUs: '" + *m_label + "' is used, '" + imu->sensorLabel + "' is not");
	else
		m_samples.push_back({imu->timestamp, *acceleration});
	return true;
}

bool GravityTrack::ready(LogTime time) const
{
	const LogTime end = later(time, kHalfWindow_s);
	return !m_label || std::any_of(m_samples.begin(), m_samples.end(), [&](const Sample& s) { return s.time >= end; });
}

std::optional<Eigen::Vector3d> GravityTrack::upAt(LogTime time) const
{
	constexpr double kGravity_mps2 = 9.8, kTolerance_mps2 = 1.5;
	Eigen::Vector3d sum = Eigen::Vector3d::Zero();
	int count = 0;
	for (const Sample& sample : m_samples)
		if (std::abs(secondsBetween(time, sample.time)) <= kHalfWindow_s)
		{
			sum += sample.acceleration_in_robot;
			++count;
		}
	if (count == 0) return std::nullopt;
	const Eigen::Vector3d mean = sum / count;
	if (!(std::abs(mean.norm() - kGravity_mps2) <= kTolerance_mps2)) return std::nullopt;
	return mean.normalized();
}

void GravityTrack::forgetBefore(LogTime time)
{
	std::erase_if(m_samples, [&](const Sample& sample) { return sample.time < time; });
}
}  // namespace explore
