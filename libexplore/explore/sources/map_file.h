// Reads OctoMap's files with care: yesterday's map to go on with.
#pragma once

#include <octomap/OcTree.h>

#include <filesystem>
#include <memory>

namespace explore
{
/** The map in a .ot file (all log-odds) or a .bt file (occupied and free voxels at OctoMap's usual limits); the file's
 *  first line tells which. Throws InputError, which names the file and the byte, for a file that cannot be read, has
 *  another kind of tree, or is damaged: OctoMap's own readers take what they get, and may not come back from it. */
std::unique_ptr<octomap::OcTree> readMapFile(const std::filesystem::path& path);
}  // namespace explore
