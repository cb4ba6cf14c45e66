#include <unistd.h>

#include <explore/simulation/sdf/world_cache.h>
#include <explore/simulation/sdf/world_layout.h>
#include <array>
#include <cstdio>
#include <fstream>

namespace explore::simulation
{
namespace fs = std::filesystem;
namespace
{
/** Raised whenever world_layout.h, or what loading makes of a world, changes. */
constexpr std::string_view kFormat = "explore-world-1\n";

std::string hexadecimal(std::uint64_t number)
{
	std::array<char, 17> text{};
	std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(number));
	return text.data();
}

using DependencyList = std::vector<std::pair<std::string, std::optional<std::uint64_t>>>;
}  // namespace

fs::path cachePathOf(const fs::path& world, const WorldPaths& paths)
{
	if (paths.cache_folder.empty()) return {};
	std::error_code error;
	std::string key = fs::absolute(world, error).lexically_normal().string();
	for (const fs::path& folder : paths.model_folders)
		key.append(":").append(fs::absolute(folder, error).lexically_normal().string());
	return paths.cache_folder / world.stem().concat("-").concat(hexadecimal(contentHash(key))).concat(".world");
}

std::optional<World> readCache(const fs::path& path)
{
	if (path.empty()) return std::nullopt;
	const std::optional<std::string> bytes = readWholeFile(path);
	constexpr std::size_t kHead = kFormat.size() + 16;
	if (!bytes || bytes->size() < kHead || !bytes->starts_with(kFormat)) return std::nullopt;
	const std::string_view content = std::string_view(*bytes).substr(kHead);
	if (bytes->substr(kFormat.size(), 16) != hexadecimal(contentHash(content))) return std::nullopt;
	ByteReader reader(content);
	DependencyList dependencies;
	reader(dependencies);
	if (!reader.good() || !Resources::unchanged({dependencies.begin(), dependencies.end()})) return std::nullopt;
	World world;
	reader(world);
	if (!reader.good() || !reader.atEnd()) return std::nullopt;
	return world;
}

void writeCache(const fs::path& path, const World& world, const Resources::Dependencies& dependencies)
{
	if (path.empty()) return;
	ByteWriter writer;
	DependencyList list(dependencies.begin(), dependencies.end());
	World copy = world;
	writer(list), writer(copy);
	std::error_code error;
	fs::create_directories(path.parent_path(), error);
	fs::path draft = path;
	draft.concat(".").concat(std::to_string(::getpid()));
	std::ofstream file(draft, std::ios::binary);
	file << kFormat << hexadecimal(contentHash(writer.bytes())) << writer.bytes();
	file.close();
	if (file) fs::rename(draft, path, error);
	if (!file || error) fs::remove(draft, error);
}
}  // namespace explore::simulation
