#include <explore/core/errors.h>
#include <explore/simulation/load_world.h>
#include <explore/simulation/sdf/label_json.h>
#include <explore/simulation/sdf/resources.h>
#include <explore/simulation/sdf/sdf_tree.h>
#include <explore/simulation/sdf/world_builder.h>
#include <explore/simulation/sdf/world_cache.h>
#include <explore/simulation/sdf/world_labels.h>

#include <algorithm>
#include <cstdlib>

namespace explore::simulation
{
namespace fs = std::filesystem;
namespace
{
World worldFromSdf(const fs::path& path, const WorldPaths& paths)
{
	Resources resources(path, paths);
	Warnings warnings;
	World world = buildWorld(readWorldTree(path, resources, warnings), path, resources, warnings);
	world.warnings = warnings.list();
	if (world.mesh.triangles.empty() && world.moving.empty())
	{
		std::string message = path.string() + ": nothing in this world can be seen";
		for (const std::string& warning : world.warnings) message.append("; ").append(warning);
		throw InputError(message);
	}
	writeCache(cachePathOf(path, paths), world, resources.dependencies());
	return world;
}

void addLabelsFile(World& world, const fs::path& world_path, const WorldPaths& paths)
{
	fs::path path = paths.labels_file;
	if (path.empty()) path = fs::path(world_path).replace_extension(".doors.json");
	const std::optional<std::string> text = readWholeFile(path);
	if (text)
		addLabels(world, parseLabelJson(*text, path.string()), path.string());
	else if (!paths.labels_file.empty())
		throw InputError(path.string() + ": the labels file cannot be read");
}
}  // namespace

WorldPaths usualWorldPaths()
{
	WorldPaths paths;
	const auto variable = [](const char* name)
	{
		const char* value = std::getenv(name);
		return std::string(value != nullptr ? value : "");
	};
	std::string folders = variable("EXPLORE_MODEL_PATH");
	for (std::size_t colon = 0; !folders.empty(); folders.erase(0, colon + 1))
	{
		colon = std::min(folders.find(':'), folders.size());
		if (colon > 0) paths.model_folders.emplace_back(folders.substr(0, colon));
		if (colon == folders.size()) break;
	}
	fs::path cache = variable("XDG_CACHE_HOME");
	if (cache.empty() && !variable("HOME").empty()) cache = fs::path(variable("HOME")) / ".cache";
	if (!cache.empty()) paths.cache_folder = cache / "explore-mrpt";
	return paths;
}

World loadWorld(const fs::path& path, const WorldPaths& paths)
{
	std::optional<World> world = readCache(cachePathOf(path, paths));
	if (!world) world = worldFromSdf(path, paths);
	addLabelsFile(*world, path, paths);
	return *std::move(world);
}
}  // namespace explore::simulation
