#include <common/exit_codes.h>
#include <common/interrupt.h>
#include <explore-mrpt/run.h>
#include <explore-mrpt/run_input.h>
#include <explore-mrpt/run_state.h>
#include <explore/core/errors.h>

namespace explore::app
{
namespace
{
/** Why no frame came. */
std::string reasonOfEnd(const Run& run)
{
	if (run.robot != nullptr) return "time limit";
	return run.source.report().damage.empty() ? "log ended" : "input damaged";
}

/** Takes the frame's result to the two ends. */
void handOver(Run& run, const DepthFrame& frame, const StepResult& result)
{
	run.link.decided(result.decision, frame.timestamp);
	run.outputs.write(frame, result);
	run.truth.add(frame, result, run.state.mission.goal_lost);
	if (run.config.output.report && run.outputs.paths()) run.truth.follow(run.state.memory.get());
	run.outputs.writeReport(frame, result, run.state, run.truth.coverage());
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
	if (!frame)
	{
		run.outputs.writeRestOfInput();
		return reasonOfEnd(run);
	}
	clock.ended("read");
	const StepResult result =
	    step(*frame, run.state, run.config.explorer, [&](std::string_view stage) { clock.ended(stage); });
	handOver(run, *frame, result);
	clock.ended("write");

	run.outputs.writeTimes(frame->index, clock.times());
	run.timing.add(clock.times());
	run.tally.add(*frame, result);
	if (const auto remark = run.depth_check.look(*frame)) run.logger.logStr(mrpt::system::LVL_WARN, *remark);
	if (run.obeyed && result.finished) return std::string(nameOf(run.state.mission.end));
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
	progress.known_free_m2 = knownFreeArea(*run.state.memory);
	return progress;
}

/** Frame after frame; returns why it ended. */
std::string exploreAll(Run& run)
{
	const auto start = std::chrono::steady_clock::now();
	while (signalReceived() == 0)
	{
		if (run.options.max_frames && run.tally.frames >= *run.options.max_frames) return std::string(kMaxFrames);
		if (auto reason = exploreOneFrame(run)) return *std::move(reason);
		if (run.keeper.due()) keepState(run);
		const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
		StatusLine& status = run.logger.status();
		if (status.isDue(elapsed.count())) status.update(progressOf(run), elapsed.count());
	}
	return std::string(kInterrupted);
}

InputSummary inputSummary(const SourceReport& report)
{
	return {
	    report.kind,          report.path,        report.skipped_frames, report.dropped_frames, report.oldest_frame_ms,
	    report.away_frames,   report.lost_bytes,  report.lost_objects,   report.damage,         report.sensor_label,
	    report.sensors_found, report.pose_origin, report.identity_mount};
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
	        processorUse(run.started),
	        explorationSummary(run.state),
	        run.truth.summary(run.state.memory ? &run.state.memory->map.tree() : nullptr)};
}

/** What is known of the building so far, where there is a memory, and the scene. */
void writeMap(Run& run)
{
	const ExplorerConfig& config = run.config.explorer;
	if (run.state.memory)
		run.outputs.writeMap(
		    run.state.memory->map.tree(),
		    {config.memory.layers.floor_z_m, lowestOfBody(config.memory.layers, config.memory.map.resolution_m),
		     config.robot.height_m});
	run.outputs.writeScene(run.state);
}

/** Explores and writes the summary, also when it ends in an error, which is passed on. */
RunSummary exploreAndSum(Run& run)
{
	try
	{
		const std::string reason = exploreAll(run);
		run.link.finish();  // at once: what is written now takes a while
		run.logger.status().finish();
		RunSummary summary = summaryOf(run, reason);
		writeMap(run);
		run.outputs.finish(summary, run.timing, run.state);
		keepLastState(run, reason);
		if (!canGoOn(run, reason)) run.outputs.forgetReportLog();
		return summary;
	}
	catch (const std::exception& error)
	{
		run.link.finish();
		run.logger.status().finish();
		try
		{
			run.outputs.finish(summaryOf(run, std::string("error: ") + error.what()), run.timing, run.state);
			writeMap(run);  // last: where the disk is full, the summary is smaller
			if (!run.keeper.keeps()) run.outputs.forgetReportLog();
		}
		catch (const OutputError&)
		{
			// The first error says why; that the summary is missing as well adds nothing.
		}
		throw;
	}
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

/** A new run, or the rest of the one that `checkpoint` is of. */
int runFrom(const Options& options, const LoadedConfig& loaded, const Checkpoint* checkpoint)
{
	ConsoleLogger logger(options);
	RunLink link(loaded.config.robot_link, logger);
	RunInput input = openInput(loaded, options, logger);
	input.source = link.linked(std::move(input.source));
	RunBeginning beginning = checkpoint != nullptr ? checkpoint->beginning : beginningOf(options, loaded);
	RunOutputs outputs(options, loaded.config, annotatedInput(beginning, loaded.config.source, input.source->report()),
	                   checkpoint != nullptr ? std::optional(checkpoint->files) : std::nullopt);
	beginning.max_frames = options.max_frames;
	beginning.realtime = options.realtime;
	CheckpointKeeper keeper(outputs.paths() ? std::optional(outputs.paths()->state) : std::nullopt,
	                        input.live ? 0.0 : loaded.config.output.checkpoint_period_s);
	Run run{options,
	        loaded.config,
	        *input.source,
	        input.robot,
	        input.robot != nullptr || (input.live && link.commands()),
	        outputs,
	        link,
	        logger,
	        beginning,
	        keeper,
	        DepthCheck(loaded.config.explorer),
	        RunTruth(input.robot)};
	if (checkpoint != nullptr) goOnFrom(*checkpoint, run);
	const RunSummary summary = exploreAndSum(run);
	const bool wants_summary = !options.quiet && !options.toStandardOutput();
	const std::string text = summaryText(summary) + "  results in " + options.out + "\n";
	if (wants_summary && usesStandardOutput(loaded.config.robot_link))
		logger.logStr(mrpt::system::LVL_INFO, text);
	else if (wants_summary)
		print(text);
	return exitCode(summary, logger);
}

/** The rest of a run, in the folder that it was begun in: names mean what they meant then. */
int resume(Options options)
{
	options.resume = std::filesystem::absolute(options.resume).string();
	const Checkpoint checkpoint = readCheckpoint(options.resume);
	if (!checkpoint.end.empty())
	{
		if (!options.quiet)
			print("The run is over already: " + checkpoint.end + "\n  results in " + options.resume + "\n");
		return kDone;
	}
	std::error_code error;
	std::filesystem::current_path(checkpoint.beginning.working_folder, error);
	if (error)
		throw InputError(checkpoint.beginning.working_folder +
		                 ": the run was begun in this folder, which cannot be entered: " + error.message());
	return runFrom(continuedOptions(options, checkpoint.beginning), loadedConfig(checkpoint.beginning), &checkpoint);
}
}  // namespace

int run(const Options& options)
{
	catchSignals();
	if (!options.resume.empty()) return resume(options);
	const LoadedConfig loaded = loadConfig(options);
	if (options.toStandardOutput() && usesStandardOutput(loaded.config.robot_link))
		throw ConfigError(
		    "[robot_link] commands = stdout: --out - writes the frames there; name another folder, or "
		    "send the commands to udp://host:port or unix:///path");
	if (!options.dump_config) return runFrom(options, loaded, nullptr);
	print(dumpConfig(loaded.config));
	return kDone;
}
}  // namespace explore::app
