#include <common/linked_source.h>
#include <explore/core/geometry.h>
#include <mrpt/obs/CObservationIMU.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace explore::app
{
namespace
{
constexpr double kOtherClock_s = 10.0;
}

LinkedSource::LinkedSource(std::unique_ptr<FrameSource> source, RobotInbox& inbox, mrpt::system::COutputLogger& logger)
    : m_source(std::move(source)), m_inbox(inbox), m_warn(logger)
{
}

std::optional<DepthFrame> LinkedSource::next()
{
	auto frame = m_source->next();
	if (!frame) return frame;
	takeMessages(frame->timestamp);
	setPose(*frame);
	setUp(*frame);
	addObstacles(*frame);
	setAlarms(*frame);
	return frame;
}

SourceReport LinkedSource::report() const
{
	SourceReport report = m_source->report();
	if (m_had_pose) report.pose_origin = PoseOrigin::robot_link;
	return report;
}

void LinkedSource::takeMessages(LogTime frame_time)
{
	const auto concerns = [&](const auto& part)
	{
		if (!part) return false;
		const double away_s = secondsBetween(frame_time, part->time);
		const bool near = std::abs(away_s) <= kOtherClock_s;
		if (!near)
			m_warn("robot link clock", "robot link: a message's time is " + std::to_string(away_s) +
			                               " s from the camera's: such messages are passed over");
		return near;
	};
	for (RobotMessage& message : m_inbox.drain())
	{
		if (concerns(message.map_from_robot)) m_poses.add(message.map_from_robot->time, message.map_from_robot->value);
		if (concerns(message.acceleration_mps2)) addAcceleration(*message.acceleration_mps2);
		if (concerns(message.scan)) m_scans.push_back(std::move(message.scan->value));
	}
	m_poses.forgetBefore(later(frame_time, -kOtherClock_s));
	std::erase_if(m_scans, [&](const auto& scan) { return secondsBetween(scan.timestamp, frame_time) > kNear_s; });
}

void LinkedSource::addAcceleration(const RobotMessage::Timed<Eigen::Vector3d>& acceleration)
{
	mrpt::obs::CObservationIMU imu;
	imu.timestamp = acceleration.time;
	imu.sensorLabel = "robot link";
	imu.set(mrpt::obs::IMU_X_ACC, acceleration.value.x());
	imu.set(mrpt::obs::IMU_Y_ACC, acceleration.value.y());
	imu.set(mrpt::obs::IMU_Z_ACC, acceleration.value.z());
	m_gravity.add(imu, m_warn);
}

void LinkedSource::setPose(DepthFrame& frame)
{
	const auto away_s = m_poses.awayFrom(frame.timestamp);
	if (away_s && *away_s <= kNear_s)
	{
		if (!m_had_pose && frame.index > 0 && frame.pose_origin != PoseOrigin::none)
			m_warn("robot link origin", "robot link: from frame " + std::to_string(frame.index) +
			                                " on, poses are the robot's: what was mapped before may lie elsewhere");
		m_had_pose = true;
		frame.map_from_robot = *m_poses.at(frame.timestamp);
		frame.pose_origin = PoseOrigin::robot_link;
	}
	else if (m_had_pose)
	{
		frame.map_from_robot = m_poses.at(frame.timestamp).value_or(mrpt::poses::CPose3D());
		frame.pose_origin = PoseOrigin::none;
		lose(frame, "pose");
	}
}

void LinkedSource::setUp(DepthFrame& frame)
{
	// The readings around a frame are not all there yet: those before it are taken.
	const LogTime middle = later(frame.timestamp, -GravityTrack::kHalfWindow_s);
	m_gravity.forgetBefore(later(middle, -GravityTrack::kHalfWindow_s));
	if (const auto up = m_gravity.upAt(middle)) frame.up_in_robot = up;
}

void LinkedSource::addObstacles(DepthFrame& frame)
{
	const auto away_s = [&](const auto& scan) { return std::abs(secondsBetween(scan.timestamp, frame.timestamp)); };
	const auto nearest = std::ranges::min_element(m_scans, {}, away_s);
	if (nearest != m_scans.end() && away_s(*nearest) <= kNear_s)
	{
		m_had_scan = true;
		frame.more_obstacles_in_robot = pointsOf(*nearest);
	}
	else if (m_had_scan)
		lose(frame, "scan");
}

void LinkedSource::setAlarms(DepthFrame& frame) const
{
	const RobotAlarms alarms = m_inbox.alarms();
	if (alarms.cliff_seen) frame.halt = RobotHalt::cliff;
	if (alarms.bumper_pressed) frame.halt = RobotHalt::bumper;
}

void LinkedSource::lose(DepthFrame& frame, const std::string& what)
{
	frame.halt = RobotHalt::link_lost;
	m_warn("robot link lost " + what, "robot link: no " + what + " within 0.2 s of frame " +
	                                      std::to_string(frame.index) + ": the robot is stopped until one comes");
}

PointCloud pointsOf(const mrpt::obs::CObservation2DRangeScan& scan)
{
	const Eigen::Isometry3d robot_from_sensor = isometryOf(scan.sensorPose);
	const auto count = static_cast<double>(scan.getScanSize());
	PointCloud points_in_robot;
	for (std::size_t i = 0; i < scan.getScanSize(); ++i)
	{
		if (!scan.getScanRangeValidity(i)) continue;
		const double angle_rad = (static_cast<double>(i) / (count - 1.0) - 0.5) * static_cast<double>(scan.aperture);
		const Eigen::Vector3d direction(std::cos(angle_rad), std::sin(angle_rad), 0.0);
		const double range_m = scan.getScanRange(i);
		points_in_robot.push_back((robot_from_sensor * (range_m * direction)).cast<float>());
	}
	return points_in_robot;
}
}  // namespace explore::app
