#include <common/camera_source.h>
#include <common/input_paths.h>
#include <common/mounted_source.h>
#include <explore-mrpt/run_input.h>
#include <explore/core/errors.h>

#include <utility>

namespace explore::app
{
namespace
{
std::unique_ptr<FrameSource> mounted(std::unique_ptr<FrameSource> source, const LoadedConfig& loaded,
                                     ConsoleLogger& logger,
                                     MountedSource::Input input = MountedSource::Input::recording)
{
	return std::make_unique<MountedSource>(std::move(source), loaded.config.source.camera.mount,
	                                       loaded.config.explorer.perception, logger, input);
}

std::unique_ptr<FrameSource> openRecording(const LoadedConfig& loaded, const Options& options, ConsoleLogger& logger)
{
	SourceConfig source = loaded.config.source;
	if (source.rawlog.empty())
		throw ConfigError("no input: name a recording with --rawlog or --oni, or in the ini with [source] rawlog");
	if (options.rawlog.empty()) source.rawlog = findRawlogOfIni(source.rawlog, loaded.ini).string();
	return mounted(makeSource(source, logger), loaded, logger);
}

/** A camera, or an .oni recording of one. */
RunInput openOpenni2(const LoadedConfig& loaded, const Options& options, ConsoleLogger& logger)
{
	SourceConfig source = loaded.config.source;
	const bool live = source.oni.empty();
	if (std::exchange(source.openni2.color, false))
		logger.logStr(mrpt::system::LVL_WARN,
		              "[openni2] color = true: colour images are kept by explore-rawlog record; this program goes by "
		              "depth alone and leaves them off");
	if (!live && options.oni.empty()) source.oni = findOniOfIni(source.oni, loaded.ini).string();
	const auto input = live ? MountedSource::Input::live : MountedSource::Input::recording;
	return {mounted(openCamera(source, logger), loaded, logger, input), nullptr, live};
}
}  // namespace

RunInput openInput(const LoadedConfig& loaded, const Options& options, ConsoleLogger& logger)
{
	if (loaded.config.source.kind == SourceKind::rawlog) return {openRecording(loaded, options, logger)};
	if (loaded.config.source.kind == SourceKind::openni2) return openOpenni2(loaded, options, logger);
	auto simulator = openSimulator(loaded, logger);
	ClosedLoopSource* const robot = simulator.get();
	return {std::move(simulator), robot};
}

void passOver(FrameSource& recording, std::size_t frames)
{
	for (std::size_t i = 0; i < frames; ++i)
		if (!recording.next())
			throw InputError(recording.report().path + ": has " + std::to_string(i) + " frames, but the run had read " +
			                 std::to_string(frames) + " of it: it is not the same recording");
}
}  // namespace explore::app
