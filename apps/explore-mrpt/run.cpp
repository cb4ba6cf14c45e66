#include <common/closed_loop_source.h>
#include <common/exit_codes.h>
#include <common/input_paths.h>
#include <common/mounted_source.h>
#include <explore-mrpt/console_logger.h>
#include <explore-mrpt/depth_check.h>
#include <explore-mrpt/interrupt.h>
#include <explore-mrpt/pace.h>
#include <explore-mrpt/run.h>
#include <explore-mrpt/run_outputs.h>
#include <explore-mrpt/run_truth.h>
#include <explore/core/errors.h>

namespace explore::app
{
namespace
{
/** The two ends and what is counted between them. */
struct Run
{
	const Options& options;
	const AppConfig& config;
	FrameSource& source;
	ClosedLoopSource* robot = nullptr;  ///< the same, where it takes commands
	RunOutputs& outputs;
	ConsoleLogger& logger;
	DepthCheck depth_check;
	Pace pace;
	RunTruth truth;
	TimingRecord timing;
	RunTally tally;
	ExplorerState state;
};

/** Why no frame came. */
std::string reasonOfEnd(const Run& run)
{
	if (run.robot != nullptr) return "time limit";
	return run.source.report().damage.empty() ? "log ended" : "input damaged";
}

/** Takes the frame's result to the two ends. */
void handOver(Run& run, const DepthFrame& frame, const StepResult& result)
{
	run.outputs.write(frame, result);
	run.truth.add(frame, result, run.state.mission.goal_lost);
	if (run.robot == nullptr) return;
	run.outputs.writeTruth(frame.timestamp, run.robot->trueState().map_from_robot);
	run.robot->obey(result.decision.command);
}

/** One frame from end to end; after the last one, why it was the last. */
std::optional<std::string> exploreOneFrame(Run& run)
{
	StageClock clock;
	clock.start();
	const auto frame = run.source.next();
	if (!frame) return reasonOfEnd(run);
	clock.ended("read");
	const StepResult result =
	    step(*frame, run.state, run.config.explorer, [&](std::string_view stage) { clock.ended(stage); });
	handOver(run, *frame, result);
	clock.ended("write");

	run.outputs.writeTimes(frame->index, clock.times());
	run.timing.add(clock.times());
	run.tally.add(*frame, result);
	if (const auto remark = run.depth_check.look(*frame)) run.logger.logStr(mrpt::system::LVL_WARN, *remark);
	if (run.robot != nullptr && result.finished) return std::string(nameOf(run.state.mission.end));
	if (run.options.realtime) run.pace.waitFor(frame->timestamp);
	return std::nullopt;
}

Progress progressOf(const Run& run)
{
	const GoalKind goal = run.tally.goal;
	Progress progress{run.tally.frames, run.source.progress(), run.tally.doors_in_view, {}, {}};
	if (goal != GoalKind::none) progress.goal = nameOf(goal);
	if (run.state.memory == nullptr) return progress;
	progress.doors = confirmedDoors(*run.state.memory);
	progress.known_free_m2 = knownFree_m2(*run.state.memory);
	return progress;
}

/** Frame after frame; returns why it ended. */
std::string exploreAll(Run& run)
{
	const auto start = std::chrono::steady_clock::now();
	while (signalReceived() == 0)
	{
		if (run.options.max_frames && run.tally.frames >= *run.options.max_frames) return "max frames";
		if (auto reason = exploreOneFrame(run)) return *std::move(reason);
		const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
		run.logger.status().update(progressOf(run), elapsed.count());
	}
	return "interrupted";
}

InputSummary inputSummary(const SourceReport& report)
{
	return {report.kind,   report.path,         report.skipped_frames, report.lost_bytes,  report.lost_objects,
	        report.damage, report.sensor_label, report.sensors_found,  report.pose_origin, report.identity_mount};
}

RunSummary summaryOf(Run& run, const std::string& reason)
{
	return {version(),
	        run.options.ini,
	        inputSummary(run.source.report()),
	        run.tally,
	        run.logger.warnings(),
	        reason,
	        run.timing.statistics(),
	        peakResidentMegabytes(),
	        explorationSummary(run.state),
	        run.truth.summary(run.state.memory ? &run.state.memory->map.tree() : nullptr)};
}

/** What is known of the building so far, where there is a memory. */
void writeMap(Run& run)
{
	if (!run.state.memory) return;
	const ExplorerConfig& config = run.config.explorer;
	run.outputs.writeMap(run.state.memory->map.tree(),
	                     {config.memory.layers.floor_z_m, config.memory.layers.lowest_m, config.robot.height_m});
}

/** Explores and writes the summary, also when it ends in an error, which is passed on. */
RunSummary exploreAndSum(Run& run)
{
	try
	{
		const std::string reason = exploreAll(run);
		run.logger.status().finish();
		RunSummary summary = summaryOf(run, reason);
		writeMap(run);
		run.outputs.finish(summary);
		return summary;
	}
	catch (const std::exception& error)
	{
		run.logger.status().finish();
		try
		{
			writeMap(run);
			run.outputs.finish(summaryOf(run, std::string("error: ") + error.what()));
		}
		catch (const OutputError&)
		{
			// The first error says why; that the summary is missing as well adds nothing.
		}
		throw;
	}
}

std::unique_ptr<FrameSource> openRecording(const LoadedConfig& loaded, const Options& options, ConsoleLogger& logger)
{
	SourceConfig source = loaded.config.source;
	if (source.rawlog.empty())
		throw ConfigError("no input: name a recording with --rawlog, or in the ini with [source] rawlog");
	if (options.rawlog.empty()) source.rawlog = findRawlogOfIni(source.rawlog, loaded.ini).string();
	return std::make_unique<MountedSource>(makeSource(source, logger), source.camera.mount,
	                                       loaded.config.explorer.perception, logger);
}

/** Where the frames come from, and the same as a robot where it is one. */
struct Input
{
	std::unique_ptr<FrameSource> source;
	ClosedLoopSource* robot = nullptr;
};

Input openInput(const LoadedConfig& loaded, const Options& options, ConsoleLogger& logger)
{
	if (loaded.config.source.kind == SourceKind::rawlog) return {openRecording(loaded, options, logger)};
	auto simulator = openSimulator(loaded, logger);
	ClosedLoopSource* const robot = simulator.get();
	return {std::move(simulator), robot};
}

int exitCode(const RunSummary& summary, ConsoleLogger& logger)
{
	const InputSummary& input = summary.input;
	if (signalReceived() != 0) return kSignalBase + signalReceived();
	if (!input.damage.empty())
	{
		logger.logFmt(mrpt::system::LVL_ERROR, "%s: damaged: %s; lost: %llu bytes, %zu objects", input.path.c_str(),
		              input.damage.c_str(), static_cast<unsigned long long>(input.lost_bytes), input.lost_objects);
		return kInputError;
	}
	if (summary.tally.frames > 0) return kDone;
	logger.logFmt(mrpt::system::LVL_ERROR, "%s: holds no depth frame", input.path.c_str());
	return kInputError;
}

void print(const std::string& text)
{
	OutputFile::standardOutput().write(text);
}
}  // namespace

int run(const Options& options)
{
	catchSignals();
	const LoadedConfig loaded = loadConfig(options);
	if (options.dump_config)
	{
		print(dumpConfig(loaded.config));
		return kDone;
	}
	ConsoleLogger logger(options);
	const Input input = openInput(loaded, options, logger);
	RunOutputs outputs(options, loaded.config);
	Run run{options,
	        loaded.config,
	        *input.source,
	        input.robot,
	        outputs,
	        logger,
	        DepthCheck(loaded.config.explorer),
	        {},
	        RunTruth(input.robot),
	        {},
	        {},
	        {}};
	const RunSummary summary = exploreAndSum(run);
	const bool wants_summary = !options.quiet && !options.toStandardOutput();
	if (wants_summary) print(summaryText(summary) + "  results in " + options.out + "\n");
	return exitCode(summary, logger);
}
}  // namespace explore::app
