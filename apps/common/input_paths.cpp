#include <common/input_paths.h>
#include <explore/core/errors.h>

namespace explore::app
{
namespace
{
namespace fs = std::filesystem;

std::vector<fs::path> dataFolders(const char* name)
{
	return {fs::path(EXPLORE_INSTALLED_DATA_DIR) / name, fs::path(EXPLORE_SOURCE_DIR) / name};
}

std::vector<fs::path> placesOf(const fs::path& name, const fs::path& ini)
{
	std::vector<fs::path> places{name};
	if (name.is_absolute()) return places;
	if (ini.has_parent_path()) places.push_back(ini.parent_path() / name);
	for (const fs::path& folder : dataFolders("rawlogs")) places.push_back(folder / name);
	return places;
}
}  // namespace

std::vector<fs::path> iniFolders()
{
	return dataFolders("ini");
}

fs::path findRawlogOfIni(const std::string& name, const fs::path& ini)
{
	std::string message = name + ": no such recording ([source] rawlog); tried:";
	for (const fs::path& place : placesOf(name, ini))
	{
		std::error_code error;
		if (fs::exists(place, error)) return place;
		message += "\n  " + place.string();
	}
	throw InputError(message);
}
}  // namespace explore::app
