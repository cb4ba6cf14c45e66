// Where the frames of a run come from: a recording, a camera, or a simulated robot.
#pragma once

#include <common/closed_loop_source.h>
#include <explore-mrpt/console_logger.h>
#include <explore-mrpt/options.h>

#include <memory>

namespace explore::app
{
/** The source, and the same as a robot where it is one. */
struct RunInput
{
	std::unique_ptr<FrameSource> source;
	ClosedLoopSource* robot = nullptr;
	bool live = false;  ///< a camera: what it delivered does not come again
};

/** `logger` outlives it. Throws ConfigError, InputError or SensorLost. */
RunInput openInput(const LoadedConfig& loaded, const Options& options, ConsoleLogger& logger);

/** Reads a recording's first `frames` once more, for a run that goes on after them. Throws InputError where it ends
 *  before. */
void passOver(FrameSource& recording, std::size_t frames);
}  // namespace explore::app
