// Finds the files that a world refers to, and remembers what the answer depended on.
#pragma once

#include <explore/simulation/load_world.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace explore::simulation
{
/** 64 bits that change when any byte of `bytes` does (for practical purposes; no protection against intent). */
std::uint64_t contentHash(std::string_view bytes);

/** The whole file; no value when it cannot be read. */
std::optional<std::string> readWholeFile(const std::filesystem::path& path);

/** The places that model:// and the like may mean for one world. */
class Resources
{
public:
	Resources(const std::filesystem::path& world, const WorldPaths& paths);

	/** The file or folder that `uri` names in `referring_file`: model://, package://, file://, the address of a model
	 * on Gazebo Fuel (taken from a local folder of its name), or a path relative to that file. */
	std::optional<std::filesystem::path> find(const std::string& uri, const std::filesystem::path& referring_file);
	/** The SDF file of the model in `folder`: the newest version up to 1.9 that its model.config lists, else model.sdf.
	 */
	std::optional<std::filesystem::path> modelFileIn(const std::filesystem::path& folder);
	/** The whole file; no value when it cannot be read. */
	std::optional<std::string> read(const std::filesystem::path& path);
	/** Every folder that was searched, for messages. */
	[[nodiscard]] std::string searched() const;

	/** What was read or looked for so far, by path; no value = it was not there. */
	using Dependencies = std::map<std::string, std::optional<std::uint64_t>>;
	[[nodiscard]] const Dependencies& dependencies() const { return m_dependencies; }
	/** Whether every file still is what it was. */
	static bool unchanged(const Dependencies& dependencies);

private:
	[[nodiscard]] bool exists(const std::filesystem::path& path);

	std::vector<std::filesystem::path> m_folders;
	Dependencies m_dependencies;
};
}  // namespace explore::simulation
