#include <explore/config/ini.h>
#include <explore/config/ini_file.h>
#include <explore/core/errors.h>

#include <cerrno>
#include <cstddef>
#include <fstream>
#include <system_error>

namespace explore
{
namespace
{
namespace fs = std::filesystem;

constexpr std::size_t kLargestBytes = std::size_t{1} << 20U;

bool isFolder(const fs::path& path)
{
	std::error_code ignored;
	return fs::is_directory(path, ignored);
}

bool isReadableKind(const fs::path& path)
{
	std::error_code ignored;
	return fs::exists(path, ignored) && !isFolder(path);
}
}  // namespace

std::string readIniFile(const fs::path& path)
{
	if (isFolder(path)) throw ConfigError(path.string() + ": is a folder; an ini file is expected");
	errno = 0;
	std::ifstream file(path, std::ios::binary);
	if (!file) throw ConfigError(path.string() + ": cannot be opened: " + std::generic_category().message(errno));

	std::string text(kLargestBytes + 1, '\0');
	file.read(text.data(), static_cast<std::streamsize>(text.size()));
	if (file.bad()) throw ConfigError(path.string() + ": cannot be read: " + std::generic_category().message(errno));
	text.resize(static_cast<std::size_t>(file.gcount()));
	if (text.size() > kLargestBytes)
		throw ConfigError(path.string() + ": is larger than 1 MiB, which no configuration is");
	return text;
}

fs::path findIni(const std::string& name, const std::vector<fs::path>& folders)
{
	std::vector<fs::path> places{name};
	if (fs::path(name).is_relative())
		for (const auto& folder : folders) places.push_back(folder / name);

	std::string tried;
	for (const auto& place : places)
	{
		if (isReadableKind(place)) return place;
		tried += "\n  " + place.string() + (isFolder(place) ? " (a folder)" : "");
	}
	throw ConfigError("no ini file '" + name + "'; looked for:" + tried);
}
}  // namespace explore
