// Where the program looks for configurations and recordings that are named without a full path.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace explore::app
{
/** The installed ini/ folder, then the one of the source tree. */
std::vector<std::filesystem::path> iniFolders();

/** The recording that an ini names: as given from the present folder, beside the ini, then in the installed and in the
 *  source tree's rawlogs/ folder. Throws InputError that lists every place tried. */
std::filesystem::path findRawlogOfIni(const std::string& name, const std::filesystem::path& ini);

/** The same for a recording of OpenNI2. */
std::filesystem::path findOniOfIni(const std::string& name, const std::filesystem::path& ini);

/** The same for a world, which is also looked for in the rawlogs/worlds/ folders. */
std::filesystem::path findWorldOfIni(const std::string& name, const std::filesystem::path& ini);
}  // namespace explore::app
