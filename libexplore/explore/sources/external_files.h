// Range images and point clouds that a rawlog keeps in files of their own.
#pragma once

#include <mrpt/obs/CObservation.h>

#include <filesystem>
#include <string>

namespace explore
{
/** The folder with the external files of `rawlog`: `configured` where given, else `<name>_Images` beside the log (as
 *  rawlog-grabber and rawlog-edit name it), else `<name>_images` or Images, else the log's own folder. */
std::filesystem::path imagesFolderOf(const std::filesystem::path& rawlog, const std::string& configured);

/** True where a part of it – ranges, points or images – is in a file of its own. */
[[nodiscard]] bool storesExternally(const mrpt::obs::CObservation& observation);

/** Loads what `observation` stores externally, relative names from `folder`. Throws UnusableFrame that names the file
 *  when it is missing or damaged. */
void loadExternalFiles(const mrpt::obs::CObservation& observation, const std::filesystem::path& folder);
}  // namespace explore
