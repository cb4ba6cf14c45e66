#include "scene_log.h"

#include <explore/core/geometry.h>
#include <explore/simulation/log_maker.h>
#include <explore/simulation/odometry.h>
#include <explore/simulation/scenes/scene.h>
#include <explore/simulation/scenes/scene_plan.h>

#include <chrono>
#include <utility>

namespace explore::simulation
{
namespace
{
using mrpt::poses::CPose3D;

constexpr double kBetweenScenes_s = 10.0, kLongestStep_s = 0.5;

/** Records one scene; everything random in it depends on its own seed. */
class SceneRecorder
{
public:
	SceneRecorder(const SceneFamily& family, const SceneLogConfig& config, int index, const ObservationSink& sink)
	    : m_config(config),
	      m_sink(sink),
	      m_index(index),
	      m_seed(mixed({config.seed, hashOf(family.name), static_cast<std::uint64_t>(config.robot.kind),
	                    static_cast<std::uint64_t>(index)})),
	      m_scene(makeScene(family, {config.seed, index, config.robot, config.looks, config.camera.intrinsics})),
	      m_imu({}, mixed({m_seed, hashOf("imu")})),
	      m_odometry(odometryConfig(), config.robot.kind, m_scene.looks.front().truth.map_from_robot,
	                 mixed({m_seed, hashOf("odometry")}))
	{
	}

	/** The truth of its frames, but for their index in the log. */
	std::vector<TruthFrame> run()
	{
		CPose3D before = m_scene.looks.front().truth.map_from_robot;
		double before_s = -kBetweenScenes_s;
		std::vector<TruthFrame> frames;
		for (std::uint64_t look = 0; look < m_scene.looks.size(); ++look)
		{
			const SceneLook& taken = m_scene.looks[look];
			m_odometry.moveTo(taken.truth.map_from_robot, taken.t_s - before_s);
			takeLook(taken, mixed({m_seed, hashOf("camera"), look}), {before, taken.t_s - before_s});
			before = taken.truth.map_from_robot, before_s = taken.t_s;
			frames.push_back(truthOf(taken));
		}
		return frames;
	}

private:
	struct Step
	{
		const CPose3D& map_from_before;
		double dt_s;
	};

	static OdometryConfig odometryConfig()
	{
		OdometryConfig config;
		config.tilt_noise_rad = 0.5 * kDegree_rad;
		return config;
	}
	/** Rounded to the clock's ticks in one way only, so that truth and log agree. */
	[[nodiscard]] mrpt::Clock::time_point timeOf(double t_s) const
	{
		const double period_s = kBetweenScenes_s + kLongestStep_s * m_config.looks;
		const std::chrono::duration<double> since_start(period_s * m_index + t_s);
		return m_config.start + std::chrono::duration_cast<mrpt::Clock::duration>(since_start);
	}
	void readImu(double t_s, const CPose3D& map_from_robot, const Step& step)
	{
		const ImuReading reading = m_imu.read(step.map_from_before, map_from_robot, {0, 0, 0}, step.dt_s);
		m_sink(*imuObservation(reading.specific_force_mps2, reading.rate_radps, timeOf(t_s), "IMU"));
	}
	void takeLook(const SceneLook& look, std::uint64_t camera_seed, const Step& step)
	{
		const CPose3D &map_from_robot = look.truth.map_from_robot, &mount = *look.truth.robot_from_camera;
		for (const double early_s : {0.08, 0.04, 0.0}) readImu(look.t_s - early_s, map_from_robot, step);
		const auto time = timeOf(look.t_s);
		m_sink(m_config.robot.kind == RobotKind::ground ? *odometryObservation(m_odometry.estimate(), time, "ODOMETRY")
		                                                : *poseObservation(m_odometry.estimate(), time, "STATE"));
		const CameraShot shot =
		    takeShot(*m_scene.rays, m_config.camera, isometryOf(map_from_robot + mount), camera_seed);
		m_sink(*depthObservation(shot, mount, time, "XTION"));
		for (const double late_s : {0.04, 0.08}) readImu(look.t_s + late_s, map_from_robot, step);
	}
	[[nodiscard]] TruthFrame truthOf(const SceneLook& look) const
	{
		TruthFrame frame = look.truth;
		frame.scene = m_index;
		frame.t = mrpt::Clock::toDouble(timeOf(look.t_s));
		for (TruthDoor& door : frame.doors) door.id = std::to_string(m_index).append("/").append(door.id);
		return frame;
	}

	const SceneLogConfig& m_config;
	const ObservationSink& m_sink;
	int m_index;
	std::uint64_t m_seed;
	Scene m_scene;
	Imu m_imu;
	Odometry m_odometry;
};
}  // namespace

TruthLog recordScenes(const SceneFamily& family, const SceneLogConfig& config, const ObservationSink& sink)
{
	TruthLog log;
	log.world = "synth";
	log.family = family.name;
	log.configuration = family.configuration;
	log.negative = family.negativeFor(config.robot.kind);
	log.robot = config.robot;
	log.noise = nameOf(config.camera.noise);
	log.seed = config.seed;
	log.intrinsics = config.camera.intrinsics;
	for (int index = 0; index < config.count; ++index)
		for (TruthFrame& frame : SceneRecorder(family, config, index, sink).run())
		{
			frame.index = log.frames.size();
			if (frame.index == 0) log.robot_from_camera = *frame.robot_from_camera;
			if (*frame.robot_from_camera == log.robot_from_camera) frame.robot_from_camera.reset();
			log.frames.push_back(std::move(frame));
		}
	return log;
}
}  // namespace explore::simulation
