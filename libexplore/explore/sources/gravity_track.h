// The direction of gravity around a frame's time, from a recorded accelerometer.
#pragma once

#include <explore/sources/log_time.h>
#include <explore/sources/warn_once.h>
#include <mrpt/obs/CObservation.h>

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace explore
{
/** Accelerations of CObservationIMU, turned into the robot frame. Of several IMUs the first one met counts. */
class GravityTrack
{
public:
	static constexpr double kHalfWindow_s = 0.1;

	/** Takes IMU observations; returns false for anything else. */
	bool add(const mrpt::obs::CObservation& observation, WarnOnce& warn);
	/** True when reading on cannot change upAt(time), or no IMU was met so far. */
	[[nodiscard]] bool ready(LogTime time) const;
	/** Unit vector against gravity in the robot frame: the mean acceleration within ±0.1 s, where its length is
	 *  9.8 ± 1.5 m/s² (else the robot accelerates, or the sensor is wrong). */
	[[nodiscard]] std::optional<Eigen::Vector3d> upAt(LogTime time) const;
	void forgetBefore(LogTime time);
	/** Writes or reads all of it. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		std::vector<Sample> samples(m_samples.begin(), m_samples.end());
		archive(m_label), archive(samples);
		m_samples.assign(samples.begin(), samples.end());
	}

private:
	struct Sample
	{
		LogTime time;
		Eigen::Vector3d acceleration_in_robot;  ///< m/s²
	};
	std::optional<std::string> m_label;
	std::deque<Sample> m_samples;
};
}  // namespace explore
