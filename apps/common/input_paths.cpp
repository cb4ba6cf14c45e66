#include <common/input_paths.h>
#include <explore/core/errors.h>

namespace explore::app
{
namespace
{
namespace fs = std::filesystem;

std::vector<fs::path> dataFolders(const char* name)
{
	std::vector<fs::path> folders{fs::path(EXPLORE_INSTALLED_DATA_DIR) / name};
#ifdef EXPLORE_SOURCE_DIR
	folders.push_back(fs::path(EXPLORE_SOURCE_DIR) / name);
#endif
	return folders;
}

std::vector<fs::path> placesOf(const fs::path& name, const fs::path& ini, const std::vector<fs::path>& folders)
{
	std::vector<fs::path> places{name};
	if (name.is_absolute()) return places;
	if (ini.has_parent_path()) places.push_back(ini.parent_path() / name);
	for (const fs::path& folder : folders) places.push_back(folder / name);
	return places;
}

/** The first place that exists; throws InputError that begins with `missing` and lists them. */
fs::path firstOf(const std::vector<fs::path>& places, std::string missing)
{
	for (const fs::path& place : places)
	{
		std::error_code error;
		if (fs::exists(place, error)) return place;
		missing += "\n  " + place.string();
	}
	throw InputError(missing);
}

fs::path findRecording(const std::string& name, const fs::path& ini, const std::string& key)
{
	return firstOf(placesOf(name, ini, dataFolders("rawlogs")), name + ": no such recording (" + key + "); tried:");
}
}  // namespace

std::vector<fs::path> iniFolders()
{
	return dataFolders("ini");
}

fs::path findRawlogOfIni(const std::string& name, const fs::path& ini)
{
	return findRecording(name, ini, "[source] rawlog");
}

fs::path findOniOfIni(const std::string& name, const fs::path& ini)
{
	return findRecording(name, ini, "[source] oni");
}

fs::path findWorldOfIni(const std::string& name, const fs::path& ini)
{
	std::vector<fs::path> folders = dataFolders("rawlogs/worlds");
	for (const fs::path& folder : dataFolders("rawlogs")) folders.push_back(folder);
	return firstOf(placesOf(name, ini, folders), name + ": no such world ([simulator] world); tried:");
}
}  // namespace explore::app
