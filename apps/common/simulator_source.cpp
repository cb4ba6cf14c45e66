#include <common/closed_loop_source.h>
#include <common/input_paths.h>
#include <common/simulated_mount.h>
#include <explore/core/errors.h>
#include <explore/navigation/keep_out.h>
#include <explore/simulation/closed_loop.h>
#include <explore/simulation/load_world.h>
#include <explore/simulation/reachable_space.h>
#include <explore/simulation/start_pose.h>
#include <explore/sources/gravity_track.h>

#include <utility>

namespace explore::app
{
namespace
{
using namespace explore::simulation;

std::filesystem::path worldPath(const LoadedConfig& loaded)
{
	const std::string& world = loaded.config.source.simulator.world;
	if (world.empty()) throw ConfigError("no world: name one with --world, or in the ini with [simulator] world");
	return findWorldOfIni(world, loaded.ini);
}

ClosedLoopConfig closedLoopConfig(const AppConfig& config, const World& world)
{
	const SimulatorConfig& simulator = config.source.simulator;
	ClosedLoopConfig loop;
	loop.recorder.camera = config.simulated_camera;
	loop.recorder.robot = config.explorer.robot;
	loop.recorder.imu_rate_hz = config.simulated_robot.imu.rate_hz;
	loop.recorder.robot_from_camera = simulatedMount(config.source.camera, loop.recorder.robot.kind);
	loop.recorder.start = mrpt::Clock::fromDouble(kUsualStart_s);
	loop.recorder.seed = static_cast<std::uint64_t>(simulator.seed);
	loop.simulated_robot = config.simulated_robot;
	loop.map_from_start = startPose(world, simulator.start, loop.recorder.robot);
	loop.exact_pose = simulator.pose == SimulatedPose::exact;
	loop.command_delay_s = simulator.command_delay_s;
	return loop;
}

class SimulatorSource : public ClosedLoopSource
{
public:
	SimulatorSource(const AppConfig& config, const std::filesystem::path& path, mrpt::system::COutputLogger& logger)
	    : m_rate_hz(config.simulated_camera.rate_hz),
	      m_time_limit_s(config.source.simulator.time_limit_s),
	      m_gravity_from_imu(config.source.gravity_from_imu),
	      m_world(loadWorld(path, usualWorldPaths())),
	      m_scene(m_world),
	      m_loop_config(closedLoopConfig(config, m_world)),
	      m_loop(m_scene, m_loop_config),
	      m_allowed(allowedArea(config.explorer.mission.bounds)),
	      m_warn(logger)
	{
		for (const std::string& warning : m_world.warnings)
			logger.logStr(mrpt::system::LVL_WARN, path.string() + ": " + warning);
		m_report.kind = "simulator";
		m_report.path = path.string();
		m_report.sensor_label = sensorLabel(config.simulated_camera);
		m_report.sensors_found = {m_report.sensor_label};
	}

	std::optional<DepthFrame> next() override
	{
		const double t_s = static_cast<double>(m_report.frames) / m_rate_hz;
		if (t_s > m_time_limit_s) return std::nullopt;
		DepthFrame frame = m_loop.next([this](const auto& imu) { m_gravity.add(imu, m_warn); });
		if (m_gravity_from_imu) frame.up_in_robot = upBefore(frame.timestamp);
		m_report.pose_origin = frame.pose_origin;
		++m_report.frames;
		return frame;
	}
	[[nodiscard]] SourceReport report() const override { return m_report; }
	[[nodiscard]] std::optional<double> progress() const override { return std::nullopt; }
	void obey(const Command& command) override { m_loop.obey(command); }
	[[nodiscard]] TrueState trueState() const override
	{
		const SimulatedRobot& robot = m_loop.robot();
		return {robot.trueState().t_s, robot.trueState().mapFromRobot(), robot.contacts(), m_loop.minClearance()};
	}
	[[nodiscard]] TruthReach reachable() const override
	{
		const auto& start = m_loop_config.map_from_start;
		return reachableSpace(m_world, m_loop_config.recorder.robot, {start.x(), start.y(), start.z()},
		                      [this](const Eigen::Vector2d& place) { return m_allowed.allows(place); });
	}
	void exchange(ByteWriter& archive) override { exchangeAll(archive); }
	void exchange(ByteReader& archive) override { exchangeAll(archive); }

private:
	template <class Archive>
	void exchangeAll(Archive& archive)
	{
		archive(m_loop), archive(m_warn), archive(m_gravity), archive(m_report.frames), archive(m_report.pose_origin);
	}
	/** From the readings up to `time`: those of a recording that come after a frame are not there yet. */
	std::optional<Eigen::Vector3d> upBefore(mrpt::Clock::time_point time)
	{
		const LogTime middle = later(time, -GravityTrack::kHalfWindow_s);
		m_gravity.forgetBefore(later(middle, -GravityTrack::kHalfWindow_s));
		return m_gravity.upAt(middle);
	}

	double m_rate_hz, m_time_limit_s;
	bool m_gravity_from_imu;
	World m_world;
	RayScene m_scene;
	ClosedLoopConfig m_loop_config;
	ClosedLoop m_loop;
	AllowedArea m_allowed;
	WarnOnce m_warn;
	GravityTrack m_gravity;
	SourceReport m_report;
};
}  // namespace

std::unique_ptr<ClosedLoopSource> openSimulator(const LoadedConfig& loaded, mrpt::system::COutputLogger& logger)
{
	return std::make_unique<SimulatorSource>(loaded.config, worldPath(loaded), logger);
}
}  // namespace explore::app
