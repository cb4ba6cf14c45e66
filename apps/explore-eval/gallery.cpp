#include <common/exit_codes.h>
#include <explore-eval/gallery.h>
#include <explore-eval/log_input.h>
#include <explore/core/errors.h>
#include <explore/evaluation/gallery_page.h>
#include <explore/sinks/camera_view.h>
#include <explore/sinks/output_file.h>
#include <explore/sinks/output_folder.h>

#include <filesystem>
#include <set>

namespace explore::app
{
namespace
{
namespace fs = std::filesystem;
using namespace evaluation;

constexpr int kWidth_px = 480, kHeight_px = 360, kJpegQuality = 80;
const fs::path kPictures = fs::path("images") / "scenes";

void drawScene(const ReplayedFrame& replayed, const ExplorerConfig& config, const fs::path& path)
{
	Canvas canvas(kWidth_px, kHeight_px, mrpt::img::TColor(0, 0, 0));
	StepResult shown = replayed.result;
	shown.percepts.doors.clear();
	shown.decision = {};
	PictureNotes notes;
	for (const Door& door : replayed.result.percepts.doors)
		notes.doors.push_back(galleryMark(door, replayed.result.percepts.ground));
	drawCameraView(canvas, {0, 0, kWidth_px - 1, kHeight_px - 1}, replayed.frame, shown,
	               {config.perception.range_filter.max_range_m, config.robot}, notes);
	if (!canvas.image().saveToFile(path.string(), kJpegQuality))
		throw OutputError(path.string() + ": cannot write the picture (disk full, or no permission)");
}

/** Draws the log's first frame under `name`. */
GalleryScene showLog(const std::string& log, const std::string& name, const LoadedConfig& loaded,
                     const EvalOptions& options)
{
	LogInput input(log, loaded, options);
	if (!input.truth()) throw InputError(log + ": has no truth beside it, which tells its family");
	const TruthLog& truth = *input.truth();
	const fs::path picture = kPictures / (name + ".jpg");
	GalleryScene scene{name, std::string(nameOf(truth.robot.kind)), truth.noise, picture.generic_string(), {}, {}};
	bool shown = false;
	input.replay([](int) { return true; },
	             [&](const ReplayedFrame& replayed)
	             {
		             if (replayed.truth == nullptr) return true;
		             scene.truth = replayed.truth->doors;
		             scene.doors = replayed.result.percepts.doors;
		             drawScene(replayed, input.config(), fs::path(options.out) / picture);
		             shown = true;
		             return false;
	             });
	if (!shown) throw InputError(log + ": holds no depth frame that its truth knows");
	return scene;
}

std::string commandOf(const EvalOptions& options)
{
	std::string command = "explore-eval gallery";
	if (!options.ini.empty()) command += " --ini " + fs::path(options.ini).filename().string();
	for (const std::string& item : options.overrides()) command += " --set " + item;
	return command + " LOG... --out " + fs::path(options.out).filename().string();
}
}  // namespace

int makeGallery(const EvalOptions& options)
{
	const LoadedConfig loaded = loadScoredConfig(options);
	makeFolder(fs::path(options.out) / kPictures);
	std::set<std::string> names;
	std::vector<GalleryScene> scenes;
	for (const std::string& log : options.logs)
	{
		const std::string name = fs::path(log).stem().string();
		if (!names.insert(name).second)
			throw ConfigError(std::string(log)
			                      .append(": another log is called ")
			                      .append(name)
			                      .append(" too; their pictures need names of their own"));
		scenes.push_back(showLog(log, name, loaded, options));
	}
	const bool paper = loaded.config.explorer.perception.method == PerceptionMethod::paper;
	const GalleryHead head{commandOf(options), paper ? "paper" : "full"};
	writeFileAtomically(fs::path(options.out) / "scene-pictures.md", galleryText(head, scenes));
	return kDone;
}
}  // namespace explore::app
