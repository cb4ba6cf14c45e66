// Keeps loaded worlds on disk, so that the next start need not read SDF and meshes again.
#pragma once

#include <explore/simulation/load_world.h>
#include <explore/simulation/sdf/resources.h>

namespace explore::simulation
{
/** Where the cache of `world`, loaded with `paths`, is; empty where paths name no cache folder. */
std::filesystem::path cachePathOf(const std::filesystem::path& world, const WorldPaths& paths);

/** The world in the cache file at `path`. No value when there is none, when it is damaged or of another version, or
 * when any file that the world was made of has changed since. */
std::optional<World> readCache(const std::filesystem::path& path);

/** Writes the cache file in one step. A cache that cannot be written is no reason to stop: then nothing happens. */
void writeCache(const std::filesystem::path& path, const World& world, const Resources::Dependencies& dependencies);
}  // namespace explore::simulation
