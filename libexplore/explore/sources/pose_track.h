// Timed poses of one origin, interpolated to a frame's time.
#pragma once

#include <explore/sources/log_time.h>
#include <mrpt/poses/CPose3D.h>

#include <deque>
#include <optional>

namespace explore
{
/** True when all of the pose is finite, its rotation is one, and it lies within 10⁶ m. */
[[nodiscard]] bool isSane(const mrpt::poses::CPose3D& pose);

/** The pose at `share` (0–1) of the way from `a` to `b`: translation on a line, rotation by slerp. */
[[nodiscard]] mrpt::poses::CPose3D interpolate(const mrpt::poses::CPose3D& a, const mrpt::poses::CPose3D& b,
                                               double share);

class PoseTrack
{
public:
	/** Times may come in any order; a second pose for the same time replaces the first. */
	void add(LogTime time, const mrpt::poses::CPose3D& map_from_robot);
	[[nodiscard]] bool empty() const { return m_samples.empty(); }
	/** True when a pose at or after `time` is known. */
	[[nodiscard]] bool reaches(LogTime time) const { return !empty() && m_samples.back().time >= time; }
	/** Interpolated inside the known times, the nearest pose outside; no value while empty. */
	[[nodiscard]] std::optional<mrpt::poses::CPose3D> at(LogTime time) const;
	/** Seconds from `time` to the nearest known time; no value while empty. */
	[[nodiscard]] std::optional<double> awayFrom(LogTime time) const;
	/** Drops what at() no longer needs for times from `time` on. */
	void forgetBefore(LogTime time);

private:
	struct Sample
	{
		LogTime time;
		mrpt::poses::CPose3D pose;
	};
	[[nodiscard]] std::deque<Sample>::const_iterator firstNotBefore(LogTime time) const;
	std::deque<Sample> m_samples;  ///< by time
};
}  // namespace explore
