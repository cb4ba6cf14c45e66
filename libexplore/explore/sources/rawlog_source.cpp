#include "rawlog_source.h"

#include <explore/core/errors.h>
#include <explore/sources/external_files.h>
#include <mrpt/obs/CActionCollection.h>

#include <algorithm>
#include <utility>

namespace explore
{
namespace
{
constexpr std::size_t kMaxPending = 64;
constexpr double kMaxWait_s = 2.0;
/** Poses this much older than the last frame are forgotten; frames that far back in time get the nearest. */
constexpr double kHistory_s = 10.0;
constexpr std::size_t kToldSkips = 5;

std::string quoted(const std::vector<std::string>& labels)
{
	std::string text;
	for (const std::string& label : labels) text += (text.empty() ? "'" : ", '") + label + "'";
	return text.empty() ? "none" : text;
}

/** Time of a sensory frame: that of its first depth image of the chosen sensor, else of its first timed observation. */
std::optional<LogTime> timeOf(const mrpt::obs::CSensoryFrame& sensory_frame, const std::string& label)
{
	std::optional<LogTime> first;
	for (const auto& observation : sensory_frame)
	{
		if (!observation || !isUsable(observation->timestamp)) continue;
		if (isDepthObservation(*observation) && (label.empty() || observation->sensorLabel == label))
			return observation->timestamp;
		if (!first) first = observation->timestamp;
	}
	return first;
}
}  // namespace

RawlogSource::RawlogSource(const SourceConfig& config, mrpt::system::COutputLogger& logger)
    : m_config(config),
      m_warn(logger),
      m_reader(config.rawlog),
      m_converter(config, imagesFolderOf(config.rawlog, config.images_folder)),
      m_poses(config.pose, m_warn)
{
	m_report.kind = "rawlog";
	m_report.path = config.rawlog;
	if (!config.sensor_label.empty()) m_label = config.sensor_label;
}

std::optional<DepthFrame> RawlogSource::next()
{
	while (!frontIsReady())
		if (!readEntry()) break;
	if (m_pending.empty())
	{
		checkInput();
		return std::nullopt;
	}
	m_poses.choose();
	DepthFrame frame = std::move(m_pending.front());
	m_pending.pop_front();
	complete(frame);
	return frame;
}

bool RawlogSource::frontIsReady() const
{
	if (m_pending.empty()) return false;
	const LogTime time = m_pending.front().timestamp;
	if (m_pending.size() >= kMaxPending || secondsBetween(time, m_log_time.value_or(time)) >= kMaxWait_s) return true;
	return m_poses.ready(time) && (!m_config.gravity_from_imu || m_gravity.ready(time));
}

void RawlogSource::complete(DepthFrame& frame)
{
	frame.index = m_report.frames++;
	frame.map_from_robot = m_poses.poseAt(frame.timestamp);
	frame.pose_origin = m_poses.origin();
	if (m_config.gravity_from_imu) frame.up_in_robot = m_gravity.upAt(frame.timestamp);
	const LogTime oldest = later(frame.timestamp, -kHistory_s);
	m_poses.forgetBefore(oldest);
	m_gravity.forgetBefore(oldest);
	if (frame.robot_from_camera != mrpt::poses::CPose3D() || m_report.identity_mount) return;
	m_report.identity_mount = true;
	if (m_config.camera.mount == MountPolicy::estimate) return;
	m_warn("identity mount", "the pose of sensor '" + frame.sensor_label +
	                             "' on the robot is the identity: the camera is taken for the robot");
}

bool RawlogSource::readEntry()
{
	const mrpt::serialization::CSerializable::Ptr object = m_reader.next();
	if (!object) return false;
	if (const auto action = std::dynamic_pointer_cast<mrpt::obs::CActionCollection>(object))
		m_poses.add(*action);
	else if (const auto sensory_frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
		takeSensoryFrame(*sensory_frame);
	else if (const auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(object))
		take(observation);
	return true;
}

void RawlogSource::takeSensoryFrame(const mrpt::obs::CSensoryFrame& sensory_frame)
{
	const auto time = timeOf(sensory_frame, m_label.value_or(""));
	if (time) m_poses.sensoryFrame(*time);
	for (const auto& observation : sensory_frame)
		if (observation) take(observation);
}

void RawlogSource::take(const mrpt::obs::CObservation::Ptr& observation)
{
	if (isUsable(observation->timestamp))
		m_log_time = std::max(m_log_time.value_or(observation->timestamp), observation->timestamp);
	if (m_poses.add(*observation) || m_gravity.add(*observation, m_warn)) return;
	if (isDepthObservation(*observation) && isChosenSensor(observation->sensorLabel)) takeDepth(*observation);
}

bool RawlogSource::isChosenSensor(const std::string& label)
{
	m_depth_met = true;
	auto& found = m_report.sensors_found;
	if (!m_label) m_label = label;
	if (std::find(found.begin(), found.end(), label) == found.end())
	{
		found.push_back(label);
		m_warn.info("depth sensor found: '" + label + "'" + (label == *m_label ? " (used)" : ""));
	}
	return label == *m_label;
}

LogTime RawlogSource::frameTime(const mrpt::obs::CObservation& observation)
{
	LogTime time = observation.timestamp;
	if (!isUsable(time))
	{
		m_warn("invalid time", "a depth frame without a valid timestamp takes that of the frame before");
		time = m_last_frame_time.value_or(mrpt::Clock::fromDouble(0.0));
	}
	else if (m_last_frame_time && time <= *m_last_frame_time)
		m_warn("time order", "depth frames are not in the order of their timestamps; they are delivered as they come");
	m_last_frame_time = time;
	return time;
}

void RawlogSource::takeDepth(mrpt::obs::CObservation& observation)
{
	try
	{
		DepthFrame frame = m_converter.convert(observation);
		frame.timestamp = frameTime(observation);
		m_pending.push_back(std::move(frame));
	}
	catch (const UnusableFrame& why)
	{
		skip(observation, why);
	}
}

void RawlogSource::skip(const mrpt::obs::CObservation& observation, const UnusableFrame& why)
{
	++m_report.skipped_frames;
	if (m_report.skipped_frames <= kToldSkips)
		m_warn(why.what(), "a frame of '" + observation.sensorLabel + "' cannot be used: " + why.what());
	else
		m_warn("more skips", "more frames cannot be used; from here on they are only counted");
	if (!why.is_damage) return;
	if (m_lost_frames++ == 0) m_first_loss = why.what();
}

void RawlogSource::checkInput() const
{
	if (m_report.frames > 0 || m_report.skipped_frames > 0) return;
	const std::string damage = m_reader.damage() ? " (" + m_reader.damage()->what + ")" : "";
	if (!m_depth_met)
		throw InputError(m_config.rawlog +
		                 ": no depth observation found; CObservation3DRangeScan, CObservationPointCloud or "
		                 "CObservationVelodyneScan is needed" +
		                 damage);
	throw InputError(m_config.rawlog + ": no depth sensor has the label '" + *m_label +
	                 "'; found: " + quoted(m_report.sensors_found) + damage);
}

SourceReport RawlogSource::report() const
{
	SourceReport report = m_report;
	report.sensor_label = m_label.value_or("");
	report.pose_origin = m_poses.origin();
	if (const auto& damage = m_reader.damage())
	{
		report.damage = damage->what;
		report.lost_bytes = damage->lost_bytes;
		report.lost_objects = damage->lost_objects;
	}
	if (m_lost_frames > 0)
	{
		report.lost_objects += m_lost_frames;
		report.damage += (report.damage.empty() ? "" : "; ") + std::to_string(m_lost_frames) +
		                 " frames cannot be used, the first because: " + m_first_loss;
	}
	return report;
}
}  // namespace explore
