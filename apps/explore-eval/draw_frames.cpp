#include <explore-eval/score_log.h>
#include <explore/core/errors.h>
#include <explore/evaluation/truth_marks.h>
#include <explore/sinks/frame_picture.h>
#include <mrpt/core/format.h>

#include <set>

namespace explore::app
{
namespace
{
constexpr int kPictureQuality = 82;

void draw(const std::string& log, const LogInput& input, const ReplayedFrame& replayed,
          const std::filesystem::path& folder)
{
	const PictureConfig config{input.config().perception.range_filter.max_range_m, input.config().robot};
	const PictureNotes notes{mrpt::format("frame %zu, scene %d", replayed.frame.index, replayed.truth->scene),
	                         evaluation::truthMarks(*replayed.truth, config.max_range_m)};
	const auto path = folder / evaluation::pictureName(log, replayed.frame.index);
	if (!drawFramePicture(replayed.frame, replayed.result, config, notes).saveToFile(path.string(), kPictureQuality))
		throw OutputError(path.string() + ": cannot write the picture (disk full, or no permission)");
}
}  // namespace

void drawFrames(const std::string& log, const FrameScenes& frames, const std::filesystem::path& folder,
                const LoadedConfig& loaded, const EvalOptions& options)
{
	if (frames.empty()) return;
	LogInput input(log, loaded, options);
	std::set<int> scenes;
	for (const auto& [frame, scene] : frames) scenes.insert(scene);
	input.replay([&](int scene) { return scenes.contains(scene); },
	             [&](const ReplayedFrame& replayed)
	             {
		             const std::size_t index = replayed.frame.index;
		             if (replayed.truth != nullptr && frames.contains(index)) draw(log, input, replayed, folder);
		             return index < frames.rbegin()->first;
	             });
}
}  // namespace explore::app
