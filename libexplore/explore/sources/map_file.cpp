#include <explore/core/errors.h>
#include <explore/sources/map_file.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

namespace explore
{
namespace
{
constexpr int kDepth = 16;

struct Header
{
	bool states_only = false;  ///< .bt
	std::size_t nodes = 0;
	double resolution_m = 0;
	std::size_t data_at = 0;  ///< byte
};

[[noreturn]] void fail(const std::filesystem::path& path, std::size_t byte, const std::string& what)
{
	throw InputError(path.string() + ": byte " + std::to_string(byte) + ": " + what);
}

std::string readWhole(const std::filesystem::path& path)
{
	std::ifstream file(path, std::ios::binary);
	std::ostringstream bytes;
	if (file) bytes << file.rdbuf();
	if (!file || bytes.str().empty())
		throw InputError(path.string() + ": cannot be read, or is empty; expected an OctoMap file (.ot or .bt)");
	return bytes.str();
}

/** The lines up to and with "data". */
Header readHeader(const std::filesystem::path& path, const std::string& bytes)
{
	Header header;
	std::istringstream lines(bytes.substr(0, 4096));
	std::string line;
	std::getline(lines, line);
	header.states_only = line == "# Octomap OcTree binary file";
	if (!header.states_only && line != "# Octomap OcTree file") fail(path, 0, "no OctoMap file (.ot or .bt)");
	bool is_octree = false;
	for (std::size_t at = line.size() + 1; std::getline(lines, line); at += line.size() + 1)
	{
		std::istringstream words(line);
		std::string key;
		words >> key;
		if (key == "data")
		{
			header.data_at = at + line.size() + 1;
			if (!is_octree || !(header.resolution_m > 0.0)) fail(path, at, "the header has no id or no resolution");
			return header;
		}
		std::string value;
		words >> value;
		if (key == "id" && !(is_octree = value == "OcTree")) fail(path, at, "a tree of kind " + value + ", not OcTree");
		if (key == "size") header.nodes = static_cast<std::size_t>(std::strtoull(value.c_str(), nullptr, 10));
		if (key == "res") header.resolution_m = std::strtod(value.c_str(), nullptr);
	}
	fail(path, 0, "the header has no end");
}

/** Walks through the data as a reader would. */
class DataCheck
{
public:
	DataCheck(const std::filesystem::path& path, const std::string& bytes, const Header& header)
	    : m_path(path), m_bytes(bytes), m_header(header), m_at(header.data_at)
	{
	}

	void run()
	{
		if (m_header.nodes > 0)
		{
			++m_nodes;
			m_header.states_only ? walkStates(0) : walkLogOdds(0);
		}
		if (m_nodes != m_header.nodes)
			fail(m_path, m_at,
			     std::to_string(m_nodes) + " nodes, but the header says " + std::to_string(m_header.nodes));
		if (m_at != m_bytes.size()) fail(m_path, m_at, "bytes after the end of the tree");
	}

private:
	std::uint8_t take()
	{
		if (m_at >= m_bytes.size()) fail(m_path, m_at, "the file ends within the tree");
		return static_cast<std::uint8_t>(m_bytes[m_at++]);
	}

	void descend(int depth) const
	{
		if (depth >= kDepth) fail(m_path, m_at, "a node below the lowest level");
	}

	/** A node: its log-odds in four bytes, a bit for each child, the children. */
	void walkLogOdds(int depth)
	{
		const std::size_t at = m_at;
		for (std::size_t i = 0; i < sizeof(float); ++i) take();
		float log_odds = 0;
		std::memcpy(&log_odds, m_bytes.data() + at, sizeof log_odds);
		if (!std::isfinite(log_odds)) fail(m_path, at, "log-odds that are no number");
		const std::uint8_t children = take();
		if (children != 0) descend(depth);
		for (int i = std::popcount(children); i > 0; --i)
		{
			++m_nodes;
			walkLogOdds(depth + 1);
		}
	}

	/** A node with children: two bits for each, the children that have children themselves. */
	void walkStates(int depth)
	{
		descend(depth);
		const unsigned first_four = take();
		const unsigned children = first_four | (static_cast<unsigned>(take()) << 8U);
		int inner = 0;
		for (unsigned i = 0; i < 8; ++i)
		{
			const unsigned kind = (children >> (2U * i)) & 3U;
			m_nodes += kind == 0 ? 0 : 1;
			inner += kind == 3 ? 1 : 0;
		}
		for (; inner > 0; --inner) walkStates(depth + 1);
	}

	const std::filesystem::path& m_path;
	const std::string& m_bytes;
	const Header& m_header;
	std::size_t m_at, m_nodes = 0;
};
}  // namespace

std::unique_ptr<octomap::OcTree> readMapFile(const std::filesystem::path& path)
{
	const std::string bytes = readWhole(path);
	const Header header = readHeader(path, bytes);
	DataCheck(path, bytes, header).run();
	auto map = std::make_unique<octomap::OcTree>(header.resolution_m);
	if (header.nodes == 0) return map;
	std::istringstream data(bytes.substr(header.data_at));
	if (header.states_only)
		map->readBinaryData(data);
	else
		map->readData(data);
	return map;
}
}  // namespace explore
