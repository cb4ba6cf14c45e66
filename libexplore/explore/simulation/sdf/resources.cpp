#include <explore/config/number_text.h>
#include <explore/simulation/sdf/resources.h>
#include <explore/simulation/sdf/xml.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstring>
#include <fstream>

namespace explore::simulation
{
namespace fs = std::filesystem;
namespace
{
/** Stands for "a folder is here" among the content hashes. */
constexpr std::uint64_t kFolder = 1;
constexpr double kNewestSdf = 1.9;

std::string percentDecoded(std::string_view text)
{
	std::string decoded;
	for (std::size_t i = 0; i < text.size(); ++i)
	{
		unsigned code = 0;
		const char* const digits = text.data() + i + 1;
		if (text[i] == '%' && i + 2 < text.size() && std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2)
			decoded.push_back(static_cast<char>(code)), i += 2;
		else
			decoded.push_back(text[i]);
	}
	return decoded;
}

/** "…/models/Ground Plane/2/files" → "Ground Plane"; the names it may have in a local folder. */
std::vector<std::string> fuelNames(std::string_view address)
{
	constexpr std::string_view kModels = "/models/";
	const std::size_t models = address.find(kModels);
	if (models == std::string_view::npos) return {};
	address.remove_prefix(models + kModels.size());
	const std::string name = percentDecoded(address.substr(0, address.find('/')));
	std::string plain = name;
	for (char& letter : plain)
		letter = letter == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
	return {name, plain};
}

/** The paths below the searched folders that `uri` may mean. */
std::vector<std::string> namesOf(std::string_view uri)
{
	const std::size_t scheme_end = uri.find("://");
	if (scheme_end == std::string_view::npos) return {std::string(uri)};
	const std::string_view scheme = uri.substr(0, scheme_end);
	std::string_view rest = uri.substr(scheme_end + 3);
	if (scheme == "http" || scheme == "https") return fuelNames(rest);
	if (scheme == "file") return {percentDecoded(rest)};
	if (scheme != "model" && scheme != "package") return {};
	while (rest.starts_with('/')) rest.remove_prefix(1);
	return {percentDecoded(rest)};
}

std::uint64_t hashOfPath(const fs::path& path)
{
	std::error_code error;
	if (fs::is_directory(path, error)) return kFolder;
	const std::optional<std::string> bytes = readWholeFile(path);
	return bytes ? contentHash(*bytes) : 0;
}
}  // namespace

std::uint64_t contentHash(std::string_view bytes)
{
	constexpr std::uint64_t kMultiplier = 0x9E3779B97F4A7C15U;
	const auto mix = [](std::uint64_t state) { return (state ^ (state >> 32U)) * kMultiplier; };
	std::uint64_t hash = mix(bytes.size() + kMultiplier);
	for (; !bytes.empty(); bytes.remove_prefix(std::min<std::size_t>(8, bytes.size())))
	{
		std::uint64_t word = 0;
		std::memcpy(&word, bytes.data(), std::min<std::size_t>(8, bytes.size()));
		hash = mix(std::rotl(hash, 23) ^ mix(word));
	}
	return std::max<std::uint64_t>(mix(hash), kFolder + 1);
}

std::optional<std::string> readWholeFile(const fs::path& path)
{
	std::error_code error;
	if (!fs::is_regular_file(path, error)) return std::nullopt;
	std::ifstream file(path, std::ios::binary);
	std::string bytes(static_cast<std::size_t>(fs::file_size(path, error)), '\0');
	if (error || !file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return std::nullopt;
	return bytes;
}

Resources::Resources(const fs::path& world, const WorldPaths& paths)
{
	std::error_code error;
	const auto add = [this, &error](const fs::path& folder)
	{
		if (fs::is_directory(folder, error) && std::find(m_folders.begin(), m_folders.end(), folder) == m_folders.end())
			m_folders.push_back(folder);
	};
	constexpr int kParents = 3;
	fs::path folder = fs::absolute(world, error).lexically_normal().parent_path();
	std::vector<fs::path> parents;
	for (int i = 0; i <= kParents && folder != folder.root_path(); ++i, folder = folder.parent_path())
		parents.push_back(folder);
	if (!parents.empty()) add(parents.front());
	for (const fs::path& parent : parents) add(parent / "models");
	for (const fs::path& model_folder : paths.model_folders) add(fs::absolute(model_folder, error).lexically_normal());
	for (const fs::path& parent : parents) add(parent);  // file://models/… counts from a project's root
}

bool Resources::exists(const fs::path& path)
{
	std::error_code error;
	const bool folder = fs::is_directory(path, error), there = folder || fs::is_regular_file(path, error);
	if (!there)
		m_dependencies.emplace(path.string(), std::nullopt);
	else if (folder)
		m_dependencies.emplace(path.string(), kFolder);
	return there;
}

std::optional<fs::path> Resources::find(const std::string& uri, const fs::path& referring_file)
{
	std::vector<fs::path> candidates;
	const fs::path own_folder = referring_file.parent_path();
	for (const fs::path name : namesOf(uri))
	{
		if (name.empty()) continue;
		if (name.is_absolute()) candidates.push_back(name);
		if (uri.find("://") == std::string::npos) candidates.push_back(own_folder / name);
		for (const fs::path& folder : m_folders) candidates.push_back(folder / name.relative_path());
		// A model may name its neighbours, wherever it was found.
		candidates.push_back(own_folder.parent_path() / name.relative_path());
	}
	for (const fs::path& candidate : candidates)
		if (exists(candidate.lexically_normal())) return candidate.lexically_normal();
	return std::nullopt;
}

std::optional<fs::path> Resources::modelFileIn(const fs::path& folder)
{
	fs::path best = folder / "model.sdf";
	double best_version = 0;
	const fs::path config = folder / "model.config";
	if (const std::optional<std::string> text = read(config))
	{
		const XmlNode model = parseXml(*text, config.string());
		for (const XmlNode& file : model.children)
		{
			const double version = file.name == "sdf" ? parseNumber(file.attribute("version")).value_or(1.0) : 0.0;
			if (version <= best_version || version > kNewestSdf || !exists(folder / file.text)) continue;
			best = folder / file.text, best_version = version;
		}
	}
	if (!exists(best)) return std::nullopt;
	return best;
}

std::optional<std::string> Resources::read(const fs::path& path)
{
	std::optional<std::string> bytes = readWholeFile(path);
	m_dependencies[path.string()] = bytes ? std::optional(contentHash(*bytes)) : std::nullopt;
	return bytes;
}

std::string Resources::searched() const
{
	std::string folders;
	for (const fs::path& folder : m_folders) folders.append(folders.empty() ? "" : ", ").append(folder.string());
	return folders;
}

bool Resources::unchanged(const Dependencies& dependencies)
{
	return std::all_of(dependencies.begin(), dependencies.end(),
	                   [](const auto& dependency)
	                   {
		                   std::error_code error;
		                   const auto& [path, hash] = dependency;
		                   return hash ? *hash == hashOfPath(path) : !fs::exists(path, error);
	                   });
}
}  // namespace explore::simulation
