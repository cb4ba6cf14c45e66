#include <explore/core/errors.h>
#include <explore/sinks/output_folder.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <vector>

namespace explore
{
namespace
{
namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const char* action, const std::error_code& error)
{
	throw OutputError(path.string() + ": cannot " + action + ": " + error.message());
}

/** NNNNNN.png, or more digits. */
bool isPictureOfOurs(const fs::path& path)
{
	const std::string stem = path.stem().string();
	return path.extension() == ".png" && stem.size() >= 6 &&
	       std::all_of(stem.begin(), stem.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool isStateOfOurs(const fs::path& path)
{
	return path.stem() == "checkpoint" || path.stem() == "report";
}
}  // namespace

void makeFolder(const fs::path& folder)
{
	std::error_code error;
	if (fs::exists(folder, error) && !fs::is_directory(folder, error))
		throw OutputError(folder.string() + ": is not a folder; --out takes the name of a folder, new or existing");
	fs::create_directories(folder, error);
	if (error) fail(folder, "create the output folder", error);
}

void removeOldFile(const fs::path& path)
{
	std::error_code error;
	fs::remove(path, error);
	if (error) fail(path, "remove the file of an earlier run", error);
}

void removeOldFiles(const fs::path& folder, const std::function<bool(const fs::path&)>& ours)
{
	if (!fs::is_directory(folder)) return;
	std::vector<fs::path> found;
	for (const auto& entry : fs::directory_iterator(folder))
		if (ours(entry.path())) found.push_back(entry.path());
	for (const auto& path : found) removeOldFile(path);
	std::error_code ignored;
	fs::remove(folder, ignored);  // stays where it holds files of others
}

OutputPaths outputPaths(const fs::path& folder)
{
	return {folder,
	        folder / "frames.jsonl",
	        folder / "timing.csv",
	        folder / "summary.json",
	        folder / "trajectory.tum",
	        folder / "pictures",
	        folder / "truth.tum",
	        folder / "map.ot",
	        folder / "map.bt",
	        folder / "map.pgm",
	        folder / "map.yaml",
	        folder / "state" / "checkpoint",
	        folder / "report.html",
	        folder / "state" / "report",
	        folder / "doors.geojson",
	        folder / "scene.3Dscene",
	        folder / "annotated.rawlog",
	        folder / "annotated_Images"};
}

OutputPaths continueOutputFolder(const fs::path& folder)
{
	OutputPaths paths = outputPaths(folder);
	for (const fs::path* file : {&paths.summary, &paths.map_ot, &paths.map_bt, &paths.map_pgm, &paths.map_yaml,
	                             &paths.report, &paths.doors, &paths.scene})
		removeOldFile(*file);
	return paths;
}

OutputPaths prepareOutputFolder(const fs::path& folder)
{
	makeFolder(folder);
	OutputPaths paths = continueOutputFolder(folder);
	for (const fs::path* file : {&paths.frames, &paths.timing, &paths.trajectory, &paths.truth, &paths.annotated})
		removeOldFile(*file);
	if (fs::is_symlink(paths.annotated_images)) removeOldFile(paths.annotated_images);
	removeOldFiles(paths.state.parent_path(), isStateOfOurs);
	removeOldFiles(paths.pictures, isPictureOfOurs);
	return paths;
}
}  // namespace explore
