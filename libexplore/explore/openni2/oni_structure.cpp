#include <explore/core/errors.h>
#include <explore/openni2/oni_structure.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <set>

namespace explore::openni2
{
namespace
{
constexpr std::uint64_t kFileHeader = 24;  // bytes
constexpr std::uint32_t kMagic = 0x0052494E;
constexpr std::uint32_t kNewData = 0x0a, kEnd = 0x0b, kNodeAdded = 0x0d;
constexpr std::uint32_t kDepthNode = 2;

/** A record begins so, little-endian; `fields` counts this header too. */
struct RecordHeader
{
	std::uint32_t magic = 0, type = 0, node = 0, fields = 0, payload = 0;
};
constexpr std::uint32_t kRecordHeader = 28;  // with the position of the record that it replaces

std::ifstream open(const std::filesystem::path& path)
{
	std::error_code error;
	if (!std::filesystem::exists(path, error)) throw InputError(path.string() + ": no such recording");
	if (!std::filesystem::is_regular_file(path, error)) throw InputError(path.string() + ": is no file");
	std::ifstream file(path, std::ios::binary);
	if (!file) throw InputError(path.string() + ": cannot be read");
	std::array<char, 4> magic{};
	if (!file.read(magic.data(), magic.size()) || std::memcmp(magic.data(), "NI10", magic.size()) != 0)
		throw InputError(path.string() + ": is no recording of OpenNI2: it does not begin with \"NI10\"");
	return file;
}

template <class Value>
bool read(std::ifstream& file, Value& value)
{
	return static_cast<bool>(file.read(reinterpret_cast<char*>(&value), sizeof value));  // NOLINT: bytes
}

/** Whether the record that adds a node, whose fields begin here with the node's name, adds a depth stream. */
bool addsDepth(std::ifstream& file)
{
	constexpr std::uint32_t kLongestName = 1024;
	std::uint32_t name = 0, type = 0;
	if (!read(file, name) || name > kLongestName) return false;
	file.seekg(name, std::ios::cur);
	return read(file, type) && type == kDepthNode;
}

std::string atByte(const char* what, std::uint64_t position)
{
	return std::string(what) + " at byte " + std::to_string(position);
}
}  // namespace

OniStructure checkStructure(const std::filesystem::path& path)
{
	std::ifstream file = open(path);
	const std::uint64_t size = std::filesystem::file_size(path);
	OniStructure found;
	std::set<std::uint32_t> depth_nodes;
	for (std::uint64_t position = kFileHeader;;)
	{
		RecordHeader record;
		file.clear();
		file.seekg(static_cast<std::streamoff>(position));
		if (!read(file, record)) return {found.depth_frames, atByte("is cut off", size)};
		const bool sane = record.magic == kMagic && record.fields >= kRecordHeader;
		if (!sane) return {found.depth_frames, atByte("is damaged", position)};
		const std::uint64_t end = position + record.fields + record.payload;
		if (end > size) return {found.depth_frames, atByte("is cut off", size)};
		if (record.type == kEnd) return found;
		file.seekg(static_cast<std::streamoff>(position + kRecordHeader));
		if (record.type == kNodeAdded && addsDepth(file)) depth_nodes.insert(record.node);
		if (record.type == kNewData && depth_nodes.contains(record.node)) ++found.depth_frames;
		position = end;
	}
}
}  // namespace explore::openni2
