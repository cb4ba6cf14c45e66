#include <explore/config/number_text.h>
#include <explore/core/errors.h>
#include <explore/simulation/closed_loop.h>
#include <explore/simulation/robot_body.h>

#include <algorithm>
#include <utility>

namespace explore::simulation
{
namespace
{
constexpr double kFarClearance_m = 1.0;

/** The same, once it is known to be fit for use. */
ClosedLoopConfig checked(ClosedLoopConfig config)
{
	const double period_s = 1.0 / config.recorder.camera.rate_hz;
	if (!(config.command_delay_s < period_s))
		throw ConfigError("command_delay = " + formatNumber(config.command_delay_s) +
		                  " s: less than the time between two frames is needed, " + formatNumber(period_s) + " s");
	return config;
}
}  // namespace

ClosedLoop::ClosedLoop(RayScene& scene, ClosedLoopConfig config)
    : m_scene(scene),
      m_config(checked(std::move(config))),
      m_robot(scene, m_config.recorder.robot, m_config.simulated_robot, m_config.map_from_start, m_config.recorder.seed)
{
}

DepthFrame ClosedLoop::next(const ObservationSink& imu)
{
	const RecorderConfig& recorder = m_config.recorder;
	// Counted from the start, so that no rounding adds up.
	const double t_s = static_cast<double>(m_frames) / recorder.camera.rate_hz;
	if (m_next_command_at_s < t_s)
	{
		goOnTo(m_next_command_at_s, imu);
		m_command = m_next_command;
	}
	goOnTo(t_s, imu);

	const auto map_from_robot = m_robot.trueState().mapFromRobot();
	DepthFrame frame;
	frame.index = m_frames;
	frame.timestamp = timeOf(recorder, t_s);
	frame.sensor_label = sensorLabel(recorder.camera);
	frame.image = takeFrame(m_scene, recorder, map_from_robot, m_frames).depth;
	frame.robot_from_camera = recorder.robot_from_camera;
	frame.map_from_robot = m_config.exact_pose ? map_from_robot : m_robot.estimate();
	const bool wheels = !m_config.exact_pose && recorder.robot.kind == RobotKind::ground;
	frame.pose_origin = wheels ? PoseOrigin::odometry : PoseOrigin::robot_pose;
	++m_frames;
	return frame;
}

void ClosedLoop::obey(const Command& command)
{
	const double last_frame_s =
	    static_cast<double>(std::max<std::size_t>(m_frames, 1) - 1) / m_config.recorder.camera.rate_hz;
	m_next_command = command;
	m_next_command_at_s = last_frame_s + m_config.command_delay_s;
}

void ClosedLoop::goOnTo(double t_s, const ObservationSink& imu)
{
	const double step_s = 1.0 / m_config.recorder.imu_rate_hz;
	for (double left_s = t_s - m_robot.trueState().t_s; left_s > 1e-9; left_s = t_s - m_robot.trueState().t_s)
	{
		const Eigen::Vector3d before = m_robot.trueState().position_in_map;
		m_robot.advance(m_command, std::min(left_s, step_s));
		watchClearance(before);
		if (imu) imu(*imuObservation(m_config.recorder, m_robot.imu(), m_robot.trueState().t_s));
	}
}

void ClosedLoop::watchClearance(const Eigen::Vector3d& before)
{
	const Eigen::Vector3d& now = m_robot.trueState().position_in_map;
	if (now == before) return;
	m_min_clearance_m =
	    bodyClearance(m_scene, m_config.recorder.robot, now, m_min_clearance_m.value_or(kFarClearance_m));
}
}  // namespace explore::simulation
