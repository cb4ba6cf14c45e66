// Finding and reading an ini file from disk.
#pragma once

#include <filesystem>
#include <string>

namespace explore
{
/** The whole file. Throws ConfigError that names it for a missing file, a folder, one that cannot be read or one far
 *  larger than any configuration. */
std::string readIniFile(const std::filesystem::path& path);
}  // namespace explore
