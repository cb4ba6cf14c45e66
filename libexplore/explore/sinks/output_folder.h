// The folder that a run writes to: which names in it are ours, and how it is made ready.
#pragma once

#include <filesystem>

namespace explore
{
/** The files of one run below its folder. */
struct OutputPaths
{
	std::filesystem::path folder, frames, timing, summary, trajectory, pictures;
};
OutputPaths outputPaths(const std::filesystem::path& folder);

/** Creates the folder where it is missing and removes the files of an earlier run, so that nothing old can be taken for
 *  new; every other file stays. Throws OutputError when `folder` is a file, or cannot be created or cleared. */
OutputPaths prepareOutputFolder(const std::filesystem::path& folder);
}  // namespace explore
