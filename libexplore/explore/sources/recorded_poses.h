// Collects every kind of pose that a rawlog carries and answers with the kind that is used.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/sources/pose_track.h>
#include <explore/sources/source_config.h>
#include <explore/sources/warn_once.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation.h>

#include <array>
#include <string>

namespace explore
{
/** map_from_robot from CObservationRobotPose, CObservationOdometry and robot movement actions. Of several sensors of
 * one kind the first one met counts. */
class RecordedPoses
{
public:
	RecordedPoses(PosePolicy policy, WarnOnce& warn) : m_policy(policy), m_warn(&warn) {}

	/** Takes odometry and robot poses; returns false for anything else. */
	bool add(const mrpt::obs::CObservation& observation);
	/** Adds up the movement; it belongs to the sensory frame that follows. */
	void add(const mrpt::obs::CActionCollection& action);
	/** A sensory frame taken at `time`, after the actions so far. */
	void sensoryFrame(LogTime time);

	/** Fixes the kind for good, from what was met so far: the asked one, or the best. */
	void choose();
	/** True when no better kind can turn up any more and a pose at or after `time` is known: no need to read on before
	 *  choosing. */
	[[nodiscard]] bool bestReaches(LogTime time) const;
	/** True when reading on cannot make poseAt(time) any better. */
	[[nodiscard]] bool ready(LogTime time) const;
	[[nodiscard]] PoseOrigin origin() const { return m_origin; }
	/** map_from_robot; the identity where there is none. */
	[[nodiscard]] mrpt::poses::CPose3D poseAt(LogTime time) const;
	void forgetBefore(LogTime time);

private:
	struct Kind
	{
		PoseTrack track;
		std::optional<std::string> label;
	};
	void addSample(PoseOrigin origin, const std::string& label, LogTime time, const mrpt::poses::CPose3D& pose);
	[[nodiscard]] Kind& kind(PoseOrigin origin) { return m_kinds[static_cast<std::size_t>(origin)]; }
	[[nodiscard]] const Kind& kind(PoseOrigin origin) const { return m_kinds[static_cast<std::size_t>(origin)]; }

	PosePolicy m_policy;
	WarnOnce* m_warn;
	std::array<Kind, 4> m_kinds;  ///< by PoseOrigin
	mrpt::poses::CPose3D m_moved;
	bool m_action_met = false, m_chosen = false;
	std::optional<LogTime> m_last_sensory_frame;
	PoseOrigin m_origin = PoseOrigin::none;
};
}  // namespace explore
