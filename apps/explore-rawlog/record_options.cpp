#include <common/app_config.h>
#include <common/config_choices.h>
#include <common/input_paths.h>
#include <common/simulated_mount.h>
#include <explore-rawlog/noise_options.h>
#include <explore-rawlog/record_options.h>
#include <explore/config/ini.h>
#include <explore/config/number_text.h>
#include <explore/core/errors.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstring>
#include <set>
#include <sstream>

namespace explore::app
{
namespace
{

void addWayOptions(CLI::App& record, RecordOptions& options)
{
	record.add_option("--world", options.world, "The Gazebo SDF world to record in")->type_name("F.sdf");
	addCameraOptions(record, options.camera);
	record
	    .add_option("--labels", options.labels,
	                "Doors, routes and more of the world; else its own and those of F.doors.json beside it")
	    ->type_name("F.doors.json");
	auto* way = record.add_option_group("way", "Where the robot goes");
	way->add_option("--path", options.path,
	                "Robot poses in the map, 't x y z qx qy qz qw' a line: the robot is moved exactly along them")
	    ->type_name("P.tum");
	way->add_option("--poses", options.poses,
	                "Robot poses in the map, 10 s apart or more: one frame at each, which is a scene of its own")
	    ->type_name("P.tum");
	way->add_option("--drive", options.drive,
	                "A route of the world by its name: a robot with dynamics and limits drives (or flies) it")
	    ->type_name("NAME");
	way->require_option(0, 1);
	record.add_option("--seconds", options.seconds, "Stops after that time; else at the way's end")
	    ->type_name("S")
	    ->check(CLI::PositiveNumber.description(""));
	record.add_option("--robot", options.robot, "ground (default) or mav; where the ini says the other, of usual size")
	    ->type_name("KIND")
	    ->transform(CLI::CheckedTransformer(kRobots, CLI::ignore_case).description(""));
	record
	    .add_option("--pose", options.mount,
	                "The camera on the robot: metres, degrees; else 0.1,0,0.5,0,0,0, on a mav 0.15,0,0,0,0,0")
	    ->type_name("X,Y,Z,YAW,PITCH,ROLL")
	    ->delimiter(',')
	    ->expected(6);
}

void addSensorOptions(CLI::App& record, RecordOptions& options)
{
	record.add_option("--sensor", options.sensor, "xtion (default), kinect or ideal")->type_name("NAME");
	record
	    .add_option("--size", options.width_px,
	                "Width of the images, three quarters of it high; else the ini's, without one 640")
	    ->type_name("PX")
	    ->check(CLI::Range(16, 4096).description(""));
	record.add_option("--noise", options.noise, "none, kinect or speckle; else the sensor's own")->type_name("NAME");
	addNoiseOptions(record, options.noise_scale, options.holes);
	record.add_option("--rate", options.rate_hz, "Depth images a second; else 10")
	    ->type_name("HZ")
	    ->check(CLI::Range(0.1, 1000.0).description(""));
	record.add_flag("--no-color", options.no_color, "Depth alone, no colour images");
}

/** What makes sense in a world alone is refused beside a camera or an .oni recording. */
void excludeFromCameras(CLI::App& record)
{
	const std::set<std::string> allowed{"--help", "--openni2", "--oni",     "--out",
	                                    "--ini",  "--set",     "--seconds", "--pose"};
	CLI::Option* const camera = record.get_option("--openni2");
	CLI::Option* const oni = record.get_option("--oni");
	camera->excludes(oni);
	std::vector<CLI::Option*> options = record.get_options();
	for (CLI::App* const group : record.get_subcommands({}))
		for (CLI::Option* const option : group->get_options()) options.push_back(option);
	for (CLI::Option* const option : options)
		if (!allowed.contains(option->get_name())) option->excludes(camera)->excludes(oni);
}

std::string quoted(const std::string& word)
{
	const bool plain =
	    !word.empty() && std::all_of(word.begin(), word.end(),
	                                 [](unsigned char c) { return std::isalnum(c) || std::strchr("_-+=.,/:@%", c); });
	if (plain) return word;
	std::string text = "'";
	for (const char letter : word)
		if (letter == '\'')
			text.append("'\\''");
		else
			text.push_back(letter);
	return text.append("'");
}

std::vector<std::string> overridesOf(const RecordOptions& options)
{
	std::vector<std::string> overrides;
	const auto add = [&](const std::string& key, const std::string& value)
	{
		if (!value.empty()) overrides.push_back("simulated_camera." + key + "=" + value);
	};
	add("name", options.sensor);
	if (options.width_px > 0) add("width_px", std::to_string(options.width_px));
	add("noise", options.noise);
	if (options.noise_scale != 1.0) add("noise_scale", formatNumber(options.noise_scale));
	if (options.holes > 0.0) add("hole_share", formatNumber(options.holes));
	if (options.rate_hz > 0.0) add("rate", formatNumber(options.rate_hz));
	add("color", options.no_color ? "false" : "true");
	overrides.insert(overrides.end(), options.set.begin(), options.set.end());
	return overrides;
}

/** What explore-mrpt has, but for a camera of full size. */
AppConfig defaults()
{
	AppConfig config;
	config.simulated_camera = simulation::depthCamera("xtion");
	return config;
}

/** Sets what file (where there is one) and overrides say. */
void load(AppConfig& config, const RecordOptions& options)
{
	const DescribeFields describe_fields = [&](FieldVisitor& visitor) { describe(visitor, config); };
	if (options.ini.empty())
		loadIniText("built-in defaults", "", overridesOf(options), describe_fields);
	else
		loadIni(findIni(options.ini, iniFolders()), overridesOf(options), describe_fields);
}

AppConfig appConfigOf(const RecordOptions& options)
{
	AppConfig first = defaults();
	load(first, options);
	const RobotKind named = first.explorer.robot.kind, kind = options.robot.value_or(named);
	AppConfig config = defaults();
	RobotConfig& robot = config.explorer.robot;
	robot = robotDefaults(kind);
	load(config, options);
	if (kind != named) robot = robotDefaults(kind);
	robot.kind = kind;
	return config;
}

mrpt::poses::CPose3D mountOf(const RecordOptions& options, const CameraConfig& camera, RobotKind kind)
{
	return options.mount.empty() ? simulatedMount(camera, kind) : poseOfOption(options.mount);
}
}  // namespace

CameraRecordOptions cameraOptionsOf(const RecordOptions& options)
{
	CameraRecordOptions camera = options.camera;
	camera.out = options.out;
	camera.ini = options.ini;
	camera.set = options.set;
	camera.mount = options.mount;
	camera.seconds = options.seconds;
	return camera;
}

void addRecordOptions(CLI::App& record, RecordOptions& options)
{
	addWayOptions(record, options);
	addSensorOptions(record, options);
	record.add_option("--seed", options.seed, "Of all noise")->type_name("N")->capture_default_str();
	record
	    .add_option("--ini", options.ini,
	                "[robot], [camera], [openni2], [simulated_camera] and [simulated_robot] from a path, or a name in "
	                "the ini/ folder")
	    ->type_name("NAME");
	record.add_option("--set", options.set, "Overrides one key of the ini; may be repeated")
	    ->type_name("SECTION.KEY=VALUE")
	    ->allow_extra_args(false);
	record.add_option("--configuration", options.configuration, "Row of explore-eval's table that the log belongs to")
	    ->type_name("TEXT");
	record.add_option("--threads", options.threads, "Processor threads; the log does not depend on them")
	    ->type_name("N")
	    ->check(CLI::Range(1, 256).description(""));
	record.add_option("--out", options.out, "The rawlog to write (gzipped); its truth goes beside it")
	    ->type_name("LOG.rawlog");
	excludeFromCameras(record);
}

std::string commandOf(const RecordOptions& options)
{
	std::string command = "explore-rawlog record";
	const auto add = [&](const std::string& name, const std::string& value)
	{
		if (!value.empty()) command.append(" ").append(name).append(" ").append(quoted(value));
	};
	const auto add_number = [&](const std::string& name, double value)
	{
		if (value != 0.0) add(name, formatNumber(value));
	};
	add("--world", options.world);
	add("--labels", options.labels);
	add("--path", options.path);
	add("--poses", options.poses);
	add("--drive", options.drive);
	add("--ini", options.ini);
	if (options.robot) add("--robot", *options.robot == RobotKind::ground ? "ground" : "mav");
	std::string mount;
	for (const double value : options.mount) mount.append(mount.empty() ? "" : ",").append(formatNumber(value));
	add("--pose", mount);
	add("--sensor", options.sensor);
	add_number("--size", options.width_px);
	add("--noise", options.noise);
	command += noiseArguments(options.noise_scale, options.holes);
	add_number("--rate", options.rate_hz);
	add_number("--seconds", options.seconds);
	if (options.no_color) command.append(" --no-color");
	for (const std::string& setting : options.set) add("--set", setting);
	add("--configuration", options.configuration);
	add("--seed", std::to_string(options.seed));
	add("--out", options.out);
	return command;
}

RecordConfig recordConfigOf(const RecordOptions& options)
{
	const AppConfig app = appConfigOf(options);
	RecordConfig config;
	config.simulated_robot = app.simulated_robot;
	config.recorder.camera = app.simulated_camera;
	config.recorder.camera.threads = std::max(options.threads, app.simulated_camera.threads);
	config.recorder.robot = app.explorer.robot;
	config.recorder.imu_rate_hz = app.simulated_robot.imu.rate_hz;
	config.recorder.robot_from_camera = mountOf(options, app.source.camera, config.recorder.robot.kind);
	config.recorder.seconds = options.seconds;
	config.recorder.seed = options.seed;
	return config;
}
}  // namespace explore::app
