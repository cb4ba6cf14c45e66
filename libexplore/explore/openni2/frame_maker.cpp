#include <explore/openni2/frame_maker.h>
#include <explore/sources/unusable_frame.h>

namespace explore::openni2
{
ScanHeader headerOf(const SourceConfig& config)
{
	ScanHeader header;
	header.sensor_label = config.sensor_label.empty() ? "OPENNI2" : config.sensor_label;
	const CameraConfig& camera = config.camera;
	const auto given = config.sensor_poses.find(header.sensor_label);
	if (camera.mount == MountPolicy::ini)
		header.robot_from_camera = {camera.x_m,     camera.y_m,       camera.z_m,
		                            camera.yaw_rad, camera.pitch_rad, camera.roll_rad};
	else if (given != config.sensor_poses.end())
		header.robot_from_camera = given->second;
	return header;
}

mrpt::Clock::time_point recordingStart()
{
	constexpr double kStart_s = 1'400'000'000.0;
	return mrpt::Clock::fromDouble(kStart_s);
}

FrameMaker::FrameMaker(const SourceConfig& config, mrpt::system::COutputLogger& logger)
    : m_config(config), m_warn(logger), m_converter(config, {}), m_header(headerOf(config))
{
	m_report.kind = "openni2";
	m_report.sensor_label = m_header.sensor_label;
	m_report.sensors_found = {m_header.sensor_label};
}

std::optional<DepthFrame> FrameMaker::make(const RawDepth& raw, mrpt::Clock::time_point time)
{
	try
	{
		auto scan = scanOf(raw, time, m_header);
		DepthFrame frame = m_converter.convert(scan);
		frame.timestamp = time;
		frame.index = m_report.frames++;
		if (frame.robot_from_camera != mrpt::poses::CPose3D() || m_report.identity_mount) return frame;
		m_report.identity_mount = true;
		if (m_config.camera.mount != MountPolicy::estimate)
			m_warn("identity mount", "the pose of sensor '" + frame.sensor_label +
			                             "' on the robot is the identity: the camera is taken for the robot");
		return frame;
	}
	catch (const UnusableFrame& why)
	{
		skip(why.what());
		return std::nullopt;
	}
}

DepthFrame FrameMaker::makeEmpty(mrpt::Clock::time_point time)
{
	DepthFrame frame;
	frame.index = m_report.frames++;
	++m_report.away_frames;
	frame.timestamp = time;
	frame.sensor_label = m_header.sensor_label;
	frame.robot_from_camera = m_header.robot_from_camera;
	return frame;
}

void FrameMaker::skip(const std::string& why)
{
	++m_report.skipped_frames;
	m_warn(why, "a frame of '" + m_header.sensor_label + "' cannot be used: " + why);
}
}  // namespace explore::openni2
