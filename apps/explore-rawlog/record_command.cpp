#include <common/exit_codes.h>
#include <explore-rawlog/noise_options.h>
#include <explore-rawlog/record_command.h>
#include <explore-rawlog/record_options.h>
#include <explore/config/number_text.h>
#include <explore/core/errors.h>
#include <explore/evaluation/truth_file.h>
#include <explore/simulation/carriers.h>
#include <explore/simulation/load_world.h>
#include <explore/simulation/random.h>
#include <explore/sources/image_folders.h>
#include <explore/sources/rawlog_writer.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

namespace explore::app
{
namespace
{
using namespace explore::simulation;

void warn(const std::string& text)
{
	std::cerr << "explore-rawlog: warning: " << text << '\n';
}

const Route& routeOf(const World& world, const RecordOptions& options)
{
	const auto named = std::find_if(world.routes.begin(), world.routes.end(),
	                                [&](const Route& route) { return route.name == options.drive; });
	if (named != world.routes.end()) return *named;
	std::string routes;
	for (const Route& route : world.routes) routes.append(routes.empty() ? "" : ", ").append(route.name);
	throw ConfigError("--drive " + options.drive + ": no route of " + options.world +
	                  (routes.empty() ? ", which has none: a --path is needed" : "; it has " + routes));
}

std::vector<TimedPose> posesIn(const std::string& file)
{
	std::vector<TimedPose> poses = readTumPoses(file);
	if (poses.empty()) throw InputError(file + ": has no pose; lines 't x y z qx qy qz qw' are needed");
	return poses;
}

std::vector<PathPose> fromStart(const std::vector<TimedPose>& poses)
{
	std::vector<PathPose> path;
	path.reserve(poses.size());
	for (const TimedPose& pose : poses) path.push_back({secondsBetween(poses.front().time, pose.time), pose.pose});
	return path;
}

std::unique_ptr<Carrier> carrierOf(RayScene& scene, const RecordOptions& options, RecordConfig& config)
{
	RecorderConfig& recorder = config.recorder;
	recorder.start = mrpt::Clock::fromDouble(kUsualStart_s);
	if (options.path.empty())
		return carrierOnRoute(scene, recorder.robot, config.simulated_robot, routeOf(scene.world(), options),
		                      options.seed);
	const std::vector<TimedPose> poses = posesIn(options.path);
	recorder.start = poses.front().time;
	return carrierOnPath(scene, recorder.robot, config.simulated_robot, fromStart(poses), options.seed);
}

void demandApart(const std::vector<TimedPose>& poses, const std::string& file)
{
	constexpr double kApart_s = 10.0;
	for (std::size_t i = 1; i < poses.size(); ++i)
		if (const double apart_s = secondsBetween(poses[i - 1].time, poses[i].time); apart_s < kApart_s)
			throw ConfigError("--poses " + file + ": pose " + std::to_string(i + 1) + " is " + formatNumber(apart_s) +
			                  " s after the one before it; scenes are 10 s apart or more");
}

/** What was recorded, and what its user should know. */
struct Recorded
{
	TruthLog truth;
	std::vector<std::string> warnings;
};

Recorded recordWay(RayScene& scene, const RecordOptions& options, RecordConfig& config, const ObservationSink& sink)
{
	const auto carrier = carrierOf(scene, options, config);
	TruthLog truth = record(scene, *carrier, config.recorder, sink);
	return {std::move(truth), carrier->warnings()};
}

/** One frame a pose: each begins anew with noise, odometry and movers of its own. */
Recorded recordPoses(RayScene& scene, const RecordOptions& options, RecordConfig& config, const ObservationSink& sink)
{
	const std::vector<TimedPose> poses = posesIn(options.poses);
	demandApart(poses, options.poses);
	Recorded all;
	for (std::size_t i = 0; i < poses.size(); ++i)
	{
		RecorderConfig one = config.recorder;
		one.start = poses[i].time;
		one.seed = mixed({options.seed, i});
		const auto carrier = carrierOnPath(scene, one.robot, config.simulated_robot, {{0.0, poses[i].pose}}, one.seed);
		TruthLog truth = record(scene, *carrier, one, sink);
		truth.frames.front().index = i;
		truth.frames.front().scene = static_cast<int>(i);
		if (i == 0)
			all.truth = std::move(truth);
		else
			all.truth.frames.push_back(std::move(truth.frames.front()));
		for (const std::string& warning : carrier->warnings())
			all.warnings.push_back(std::string("pose ").append(std::to_string(i + 1)).append(": ").append(warning));
	}
	all.truth.seed = options.seed;
	return all;
}

void demandWay(const RecordOptions& options)
{
	if (options.world.empty()) throw ConfigError("record needs one of --world F.sdf, --openni2 and --oni F.oni");
	if (options.path.empty() && options.poses.empty() && options.drive.empty())
		throw ConfigError("--world needs a way through it: one of --path, --poses and --drive");
	if (options.out.empty()) throw ConfigError("--out LOG.rawlog is needed");
}

int recordLog(const RecordOptions& options)
{
	if (options.camera.given()) return recordCamera(cameraOptionsOf(options));
	demandWay(options);
	RecordConfig config = recordConfigOf(options);
	WorldPaths paths = usualWorldPaths();
	paths.labels_file = options.labels;
	const World world = loadWorld(options.world, paths);
	for (const std::string& warning : world.warnings) warn(options.world + ": " + warning);
	if (world.doors.empty()) warn(options.world + ": labels no doors, so the truth tells of none");
	RayScene scene(world);

	std::optional<RawlogWriter> writer;  // opened late: a wrong way leaves an older file alone
	const auto sink = [&](const mrpt::obs::CObservation& observation)
	{
		if (!writer) writer.emplace(options.out);
		writer->write(observation);
	};
	auto [truth, warnings] = (options.poses.empty() ? recordWay : recordPoses)(scene, options, config, sink);
	writer->close();
	truth.world = std::filesystem::path(options.world).filename().string();
	truth.configuration = options.configuration;
	truth.command = commandOf(options);
	truth.noise = noiseName(config.recorder.camera);
	const std::filesystem::path truth_path = evaluation::truthPathOf(options.out);
	evaluation::writeTruth(truth_path, truth);

	for (const std::string& warning : warnings) warn(warning);
	std::cout << options.out << ": " << truth.frames.size() << " frames, "
	          << (truth.frames.back().t - truth.frames.front().t) << " s; truth in " << truth_path.string() << '\n';
	return kDone;
}
}  // namespace

void addRecordCommand(CLI::App& app, std::function<int()>& command)
{
	auto options = std::make_shared<RecordOptions>();
	CLI::App* record = app.add_subcommand(
	    "record",
	    "Makes a rawlog of what a depth camera sees, or, with its truth, of a way through a simulated world.");
	addRecordOptions(*record, *options);
	record->callback([options, &command] { command = [options] { return recordLog(*options); }; });
}
}  // namespace explore::app
