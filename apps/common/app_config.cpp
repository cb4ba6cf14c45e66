#include <common/app_config.h>
#include <common/input_paths.h>
#include <explore/config/ini.h>
#include <explore/navigation/keep_out.h>

namespace explore::app
{
namespace
{
/** Sets what file (where there is one) and overrides say. */
void load(AppConfig& config, const std::filesystem::path& ini, const std::vector<std::string>& overrides)
{
	const DescribeFields fields = [&](FieldVisitor& visitor) { describe(visitor, config); };
	if (ini.empty())
		loadIniText("built-in defaults", "", overrides, fields);
	else
		loadIni(ini, overrides, fields);
}

/** The kind of robot that ini and overrides name. */
RobotKind namedKind(const std::filesystem::path& ini, const std::vector<std::string>& overrides)
{
	AppConfig config;
	load(config, ini, overrides);
	return config.explorer.robot.kind;
}
}  // namespace

void describe(FieldVisitor& fields, AppConfig& config)
{
	describe(fields, config.source);
	describe(fields, config.simulated_camera);
	describe(fields, config.simulated_robot);
	describe(fields, config.explorer);
	describe(fields, config.output);
	describe(fields, config.robot_link);
}

RobotConfig robotDefaults(RobotKind kind)
{
	RobotConfig robot;
	if (kind == RobotKind::ground) return robot;
	robot.kind = RobotKind::mav;
	robot.radius_m = 0.30;
	robot.height_m = 0.25;
	robot.max_speed_mps = 0.8;
	return robot;
}

LoadedConfig loadConfig(const ConfigChoices& choices)
{
	LoadedConfig loaded;
	if (!choices.ini.empty()) loaded.ini = findIni(choices.ini, iniFolders());
	const auto overrides = choices.overrides();
	const RobotKind named = namedKind(loaded.ini, overrides), kind = choices.robot.value_or(named);

	RobotConfig& robot = loaded.config.explorer.robot;
	robot = robotDefaults(kind);
	load(loaded.config, loaded.ini, {});
	if (kind != named) robot = robotDefaults(kind);
	applyOverrides(loaded.config, overrides);
	robot.kind = kind;

	SourceConfig& source = loaded.config.source;
	if (!choices.rawlog.empty()) source.kind = SourceKind::rawlog;
	if (!choices.rawlog.empty()) source.rawlog = choices.rawlog;
	if (!choices.oni.empty()) source.kind = SourceKind::openni2;
	if (!choices.oni.empty()) source.oni = choices.oni;
	if (!choices.world.empty()) source.kind = SourceKind::simulator;
	if (!choices.world.empty()) source.simulator.world = choices.world;
	if (!choices.sensors_pose.empty()) source.sensor_poses = loadSensorPoses(choices.sensors_pose);
	allowedArea(loaded.config.explorer.mission.bounds);  // throws where it makes no sense, before anything starts
	check(loaded.config.robot_link);
	return loaded;
}

void applyOverrides(AppConfig& config, const std::vector<std::string>& overrides)
{
	load(config, {}, overrides);
}

std::string dumpConfig(AppConfig config)
{
	return dumpIni([&](FieldVisitor& visitor) { describe(visitor, config); });
}
}  // namespace explore::app
