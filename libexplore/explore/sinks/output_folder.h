// The folder that a run writes to: which names in it are ours, and how it is made ready.
#pragma once

#include <filesystem>
#include <functional>

namespace explore
{
/** The files of one run below its folder. `report_log` is what `report` is made of in the end; `annotated_images` is a
 *  link to the folder that external images of `annotated` are in. */
struct OutputPaths
{
	std::filesystem::path folder, frames, timing, summary, trajectory, pictures, truth, map_ot, map_bt, map_pgm,
	    map_yaml, state, report, report_log, doors, scene, annotated, annotated_images;
};
OutputPaths outputPaths(const std::filesystem::path& folder);

/** Creates `folder` where it is missing. Throws OutputError when it is a file or cannot be created. */
void makeFolder(const std::filesystem::path& folder);
/** Removes the file of an earlier run, where there is one. Throws OutputError. */
void removeOldFile(const std::filesystem::path& path);

/** Removes the files of an earlier run below `folder` for which `ours` holds, and the folder when nothing is left in
 * it. Throws OutputError. */
void removeOldFiles(const std::filesystem::path& folder, const std::function<bool(const std::filesystem::path&)>& ours);

/** Creates the folder where it is missing and removes the files of an earlier run, so that nothing old can be taken for
 *  new; every other file stays. Throws OutputError when `folder` is a file, or cannot be created or cleared. */
OutputPaths prepareOutputFolder(const std::filesystem::path& folder);
/** For a run that goes on: removes what only its end writes, and keeps all else. Throws OutputError. */
OutputPaths continueOutputFolder(const std::filesystem::path& folder);
}  // namespace explore
