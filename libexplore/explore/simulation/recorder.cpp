#include <explore/core/geometry.h>
#include <explore/simulation/log_maker.h>
#include <explore/simulation/random.h>
#include <explore/simulation/recorder.h>
#include <explore/simulation/truth_rays.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>

namespace explore::simulation
{
namespace
{
class Recorder
{
public:
	Recorder(RayScene& scene, Carrier& carrier, const RecorderConfig& config, const ObservationSink& sink)
	    : m_scene(scene), m_carrier(carrier), m_config(config), m_sink(sink), m_label(sensorLabel(config.camera))
	{
	}

	std::vector<TruthFrame> run()
	{
		const double limit = m_config.seconds > 0.0 ? m_config.seconds : HUGE_VAL;
		for (long frame = 0, reading = 0;;)
		{
			// Both clocks count from the start, so that no rounding adds up.
			const double frame_s = static_cast<double>(frame) / m_config.camera.rate_hz;
			const double reading_s = static_cast<double>(reading) / m_config.imu_rate_hz;
			if (std::min(frame_s, reading_s) > limit) break;
			m_carrier.advanceTo(std::min(frame_s, reading_s));
			if (reading_s <= frame_s)
			{
				m_sink(*imuObservation(m_config, m_carrier.imu(), reading_s));
				++reading;
				continue;
			}
			addFrame(frame_s);
			++frame;
			if (m_carrier.finished()) break;
		}
		return std::move(m_frames);
	}

private:
	void addFrame(double t_s)
	{
		const auto time = timeOf(m_config, t_s);
		const bool ground = m_config.robot.kind == RobotKind::ground;
		m_sink(ground ? *odometryObservation(m_carrier.estimate(), time, "ODOMETRY")
		              : *poseObservation(m_carrier.estimate(), time, "STATE"));
		const auto map_from_robot = m_carrier.truePose();
		const CameraShot shot = takeFrame(m_scene, m_config, map_from_robot, m_frames.size());
		m_sink(*depthObservation(shot, m_config.robot_from_camera, time, m_label, m_config.camera.max_range_m));

		const TruthCamera camera{m_config.camera.intrinsics, m_config.robot_from_camera};
		TruthFrame& truth = m_frames.emplace_back(truthAt(m_scene, camera, m_config.robot, map_from_robot));
		truth.index = m_frames.size() - 1;
		truth.t = mrpt::Clock::toDouble(time);
	}

	RayScene& m_scene;
	Carrier& m_carrier;
	const RecorderConfig& m_config;
	const ObservationSink& m_sink;
	std::string m_label;
	std::vector<TruthFrame> m_frames;
};
}  // namespace

mrpt::poses::CPose3D usualMount(RobotKind kind)
{
	return kind == RobotKind::ground ? mrpt::poses::CPose3D(0.10, 0.0, 0.50, 0, 0, 0)
	                                 : mrpt::poses::CPose3D(0.15, 0.0, 0.0, 0, 0, 0);
}

mrpt::Clock::time_point timeOf(const RecorderConfig& config, double t_s)
{
	return config.start + std::chrono::duration_cast<mrpt::Clock::duration>(std::chrono::duration<double>(t_s));
}

std::string sensorLabel(const DepthCameraConfig& camera)
{
	std::string label = camera.name;
	std::transform(label.begin(), label.end(), label.begin(),
	               [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
	return label;
}

CameraShot takeFrame(const RayScene& scene, const RecorderConfig& config, const mrpt::poses::CPose3D& map_from_robot,
                     std::size_t frame)
{
	return takeShot(scene, config.camera, isometryOf(map_from_robot + config.robot_from_camera),
	                mixed({config.seed, hashOf("camera"), frame}));
}

mrpt::obs::CObservation::Ptr imuObservation(const RecorderConfig& config, const ImuReading& reading, double t_s)
{
	return imuObservation(reading.specific_force_mps2, reading.rate_radps, timeOf(config, t_s), "IMU");
}

TruthLog record(RayScene& scene, Carrier& carrier, const RecorderConfig& config, const ObservationSink& sink)
{
	TruthLog truth;
	truth.robot = config.robot;
	truth.noise = nameOf(config.camera.noise);
	truth.seed = config.seed;
	truth.intrinsics = config.camera.intrinsics;
	truth.robot_from_camera = config.robot_from_camera;
	truth.frames = Recorder(scene, carrier, config, sink).run();
	return truth;
}
}  // namespace explore::simulation
