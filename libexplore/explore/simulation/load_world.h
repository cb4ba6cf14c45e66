// Reads Gazebo SDF worlds.
#pragma once

#include <explore/simulation/world.h>

#include <filesystem>
#include <vector>

namespace explore::simulation
{
struct WorldPaths
{
	/** Folders searched for model:// and file:// URIs after the world's own folder and its models/. */
	std::vector<std::filesystem::path> model_folders;
	/** Where baked meshes are kept between runs; empty = nowhere. */
	std::filesystem::path cache_folder;
	/** A file of labels (doc/worlds.md); empty = `<stem>.doors.json` beside the world, if there is one. */
	std::filesystem::path labels_file;
};

/** EXPLORE_MODEL_PATH (colon-separated) and the user's cache folder ($XDG_CACHE_HOME or ~/.cache). */
WorldPaths usualWorldPaths();

/** The world in `path`, labels included: from our plugin elements, then from the labels file. What is not
 *  supported or broken is left out and named in World::warnings. One geometry, that of the `<visual>`s, is both seen
 * and solid; everything but actors and our own `<moving>` labels stands still. Throws InputError, which names file,
 * line and reason, when no usable world remains or a label is wrong. */
World loadWorld(const std::filesystem::path& path, const WorldPaths& paths);
}  // namespace explore::simulation
