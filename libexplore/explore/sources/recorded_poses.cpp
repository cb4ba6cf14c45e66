#include "recorded_poses.h"

#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include <algorithm>

namespace explore
{
namespace
{
constexpr std::array kBestFirst = {PoseOrigin::robot_pose, PoseOrigin::odometry, PoseOrigin::action};

/** The kind that `policy` asks for; none for automatic and none. */
PoseOrigin askedBy(PosePolicy policy)
{
	switch (policy)
	{
		case PosePolicy::robot_pose:
			return PoseOrigin::robot_pose;
		case PosePolicy::odometry:
			return PoseOrigin::odometry;
		case PosePolicy::action:
			return PoseOrigin::action;
		default:
			return PoseOrigin::none;
	}
}
}  // namespace

bool RecordedPoses::add(const mrpt::obs::CObservation& observation)
{
	using mrpt::poses::CPose3D;
	if (const auto* odometry = dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation))
	{
		addSample(PoseOrigin::odometry, odometry->sensorLabel, odometry->timestamp, CPose3D(odometry->odometry));
		return true;
	}
	if (const auto* robot = dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&observation))
	{
		// The sensor says where it is itself; the robot is where the sensor's mount says.
		addSample(PoseOrigin::robot_pose, robot->sensorLabel, robot->timestamp,
		          robot->pose.mean + (-robot->sensorPose));
		return true;
	}
	return false;
}

void RecordedPoses::addSample(PoseOrigin origin, const std::string& label, LogTime time,
                              const mrpt::poses::CPose3D& pose)
{
	const std::string name = nameOf(origin);
	if (!kind(origin).label) kind(origin).label = label;
	if (*kind(origin).label != label)
		(*m_warn)("pose label " + name + label, "poses of kind " + name + " come from several sensors: '" +
		                                            *kind(origin).label + "' is used, '" + label + "' is not");
	else if (!isUsable(time) || !isSane(pose))
		(*m_warn)("bad pose " + name,
		          "a recorded pose (" + name + ") has an invalid time or is not finite; it is left out");
	else
		kind(origin).track.add(time, pose);
	if (m_chosen && m_origin == PoseOrigin::none && m_policy != PosePolicy::none && !kind(origin).track.empty())
		(*m_warn)("late poses",
		          "poses (" + name + ") begin only after the first frames were delivered without; they are not used");
}

void RecordedPoses::add(const mrpt::obs::CActionCollection& action)
{
	mrpt::poses::CPose3D increment;
	if (!action.getFirstMovementEstimationMean(increment)) return;
	if (!isSane(increment) || !isSane(m_moved + increment))
	{
		(*m_warn)("bad action", "a recorded movement is not finite; it is left out");
		return;
	}
	if (!m_action_met && m_last_sensory_frame) addSample(PoseOrigin::action, {}, *m_last_sensory_frame, m_moved);
	m_action_met = true;
	m_moved = m_moved + increment;
}

void RecordedPoses::sensoryFrame(LogTime time)
{
	if (m_action_met) addSample(PoseOrigin::action, {}, time, m_moved);
	m_last_sensory_frame = time;
}

void RecordedPoses::choose()
{
	if (m_chosen) return;
	m_chosen = true;
	if (m_policy == PosePolicy::none) return;
	const PoseOrigin asked = askedBy(m_policy);
	for (const PoseOrigin origin : kBestFirst)
		if ((m_policy == PosePolicy::automatic || origin == asked) && m_origin == PoseOrigin::none &&
		    !kind(origin).track.empty())
			m_origin = origin;
	if (m_origin != PoseOrigin::none)
		m_warn->info("poses of the robot: " + nameOf(m_origin));
	else if (asked != PoseOrigin::none)
		(*m_warn)("no pose", "no pose of the asked kind (" + nameOf(asked) +
		                         ") around the first frame: the robot's pose is the identity throughout");
	else
		(*m_warn)("no pose", "no robot pose around the first frame: the robot's pose is the identity throughout");
}

bool RecordedPoses::bestReaches(LogTime time) const
{
	if (m_policy == PosePolicy::none) return true;
	const PoseOrigin best = m_policy == PosePolicy::automatic ? kBestFirst.front() : askedBy(m_policy);
	return kind(best).track.reaches(time);
}

bool RecordedPoses::ready(LogTime time) const
{
	if (!m_chosen) return bestReaches(time);
	return m_origin == PoseOrigin::none || kind(m_origin).track.reaches(time);
}

mrpt::poses::CPose3D RecordedPoses::poseAt(LogTime time) const
{
	if (m_origin == PoseOrigin::none) return {};
	return kind(m_origin).track.at(time).value_or(mrpt::poses::CPose3D());
}

void RecordedPoses::forgetBefore(LogTime time)
{
	for (Kind& each : m_kinds) each.track.forgetBefore(time);
}
}  // namespace explore
