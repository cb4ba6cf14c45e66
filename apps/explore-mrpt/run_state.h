// A run between two frames: all that goes on from one to the next, and its way into a checkpoint and back.
#pragma once

#include <common/closed_loop_source.h>
#include <explore-mrpt/checkpoint.h>
#include <explore-mrpt/console_logger.h>
#include <explore-mrpt/depth_check.h>
#include <explore-mrpt/pace.h>
#include <explore-mrpt/run_link.h>
#include <explore-mrpt/run_outputs.h>
#include <explore-mrpt/run_truth.h>

#include <chrono>

namespace explore::app
{
/** The two ends and what is counted between them. */
struct Run
{
	const Options& options;
	const AppConfig& config;
	FrameSource& source;
	ClosedLoopSource* robot = nullptr;  ///< the same, where it takes commands
	bool obeyed = false;  ///< what is decided moves the camera: when the exploration is over, so is the run
	RunOutputs& outputs;
	RunLink& link;
	ConsoleLogger& logger;
	const RunBeginning& beginning;
	CheckpointKeeper& keeper;
	DepthCheck depth_check;
	RunTruth truth;
	std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
	Pace pace{};
	TimingRecord timing{};
	RunTally tally{};
	ExplorerState state{};
};

/** Ends after which a run can go on. */
inline constexpr std::string_view kMaxFrames = "max frames", kInterrupted = "interrupted";

/** Keeps what the run goes on from. */
void keepState(Run& run);
/** The last one of a run, when all its other files are written; of one that is over only why. */
void keepLastState(Run& run, const std::string& reason);
/** Whether --resume can go on after an end with this reason. */
[[nodiscard]] bool canGoOn(const Run& run, const std::string& reason);
/** Takes a run that was made alike to where it was. Throws InputError where the state is not one of such a run, or the
 *  recording another. */
void goOnFrom(const Checkpoint& checkpoint, Run& run);
}  // namespace explore::app
