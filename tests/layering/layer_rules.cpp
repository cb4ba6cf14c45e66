#include "layer_rules.h"

#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <string_view>

namespace explore::test
{
namespace
{
using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name)
{
	return std::ranges::find(names, name) != names.end();
}

std::string listOf(const Names& names)
{
	std::string list;
	for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
	return list.empty() ? "nothing" : list;
}

const Layer* layerOf(const std::vector<Layer>& layers, const std::string& path)
{
	const auto found = std::ranges::find_if(layers, [&](const Layer& layer) { return path.starts_with(layer.folder); });
	return found == layers.end() ? nullptr : &*found;
}

bool isCode(const std::string& path)
{
	return path.ends_with(".h") || path.ends_with(".cpp");
}

/** The C++ library's headers have neither folder nor extension. */
bool isStandard(const std::string& target)
{
	return target.find_first_of("/.") == std::string::npos;
}

/** The operating system's headers. */
bool isPosix(const std::string& target)
{
	static constexpr std::array<std::string_view, 9> kHeaders{
	    "errno.h", "fcntl.h", "netdb.h", "poll.h", "pthread.h", "signal.h", "time.h", "termios.h", "unistd.h"};
	return target.starts_with("sys/") || std::ranges::find(kHeaders, target) != kHeaders.end();
}

bool touchesTheWorld(const std::string& target)
{
	static constexpr std::array<std::string_view, 13> kHeaders{
	    "chrono", "condition_variable", "csignal", "cstdio", "ctime",      "filesystem", "fstream",
	    "future", "iostream",           "mutex",   "thread", "stop_token", "syncstream"};
	return isPosix(target) || std::ranges::find(kHeaders, target) != kHeaders.end();
}

/** What is wrong with `include` in a file of `layer`; empty when nothing is. */
std::string objection(const SourceTree& tree, const std::vector<Layer>& layers, const Layer& layer,
                      const std::string& path, const Include& include)
{
	if (include.form == Include::Form::computed) return "an include through a macro cannot be checked";
	if (const std::string target = resolve(tree, path, include); !target.empty())
	{
		const Layer* other = layerOf(layers, target);
		const bool allowed = other != nullptr && (other == &layer || contains(layer.sees, other->name));
		return allowed ? "" : "layer " + layer.name + " sees " + listOf(layer.sees) + ", not " + target;
	}
	if (include.form == Include::Form::quoted) return "\"" + include.target + "\" is no file of the project";
	if (isStandard(include.target) || isPosix(include.target))
		return layer.pure && touchesTheWorld(include.target)
		           ? "layer " + layer.name + " has no side effects, so no <" + include.target + ">"
		           : "";
	const std::string package = include.target.substr(0, include.target.find('/'));
	if (contains(layer.third_party, package)) return "";
	return "layer " + layer.name + " may use " + listOf(layer.third_party) + ", not <" + include.target + ">";
}

/** Depth-first search for include cycles. */
class CycleSearch
{
public:
	explicit CycleSearch(const SourceTree& tree) : m_tree(tree) {}

	std::vector<std::string> run()
	{
		for (const auto& [path, text] : m_tree) visit(path);
		return m_cycles;
	}

private:
	void visit(const std::string& path)
	{
		if (const auto open = std::ranges::find(m_way, path); open != m_way.end())
		{
			std::string cycle;
			for (auto step = open; step != m_way.end(); ++step) cycle.append(*step).append(" -> ");
			m_cycles.push_back(cycle + path);
			return;
		}
		if (!m_done.insert(path).second) return;
		m_way.push_back(path);
		for (const Include& include : includesOf(m_tree.at(path)))
			if (const std::string target = resolve(m_tree, path, include); !target.empty()) visit(target);
		m_way.pop_back();
	}

	const SourceTree& m_tree;
	std::vector<std::string> m_way;
	std::set<std::string> m_done;
	std::vector<std::string> m_cycles;
};

/** The `//` lines that `text` begins with, joined. */
std::string openingComment(const std::string& text)
{
	std::string comment;
	for (std::size_t at = 0; at < text.size() && text.compare(at, 3, "// ") == 0;)
	{
		const std::size_t end = std::min(text.find('\n', at), text.size());
		comment += text.substr(at + 2, end - at - 2);
		at = end + 1;
	}
	return comment;
}
}  // namespace

std::vector<std::string> includeViolations(const SourceTree& tree, const std::vector<Layer>& layers)
{
	std::vector<std::string> violations;
	for (const auto& [path, text] : tree)
	{
		if (!isCode(path)) continue;
		const Layer* layer = layerOf(layers, path);
		if (layer == nullptr)
		{
			violations.push_back(path + ": belongs to no layer; name its folder in projectLayers()");
			continue;
		}
		for (const Include& include : includesOf(text))
			if (const std::string why = objection(tree, layers, *layer, path, include); !why.empty())
				violations.push_back(path + ":" + std::to_string(include.line) + ": " + why);
	}
	return violations;
}

std::vector<std::string> linkViolations(const SourceTree& tree, const std::vector<Layer>& layers)
{
	static const std::regex kTarget("explore::([a-z_]+)");
	std::vector<std::string> violations;
	for (const auto& [path, text] : tree)
	{
		const Layer* layer = layerOf(layers, path);
		if (!path.ends_with("layer.cmake") || layer == nullptr) continue;
		for (std::sregex_iterator match(text.begin(), text.end(), kTarget), end; match != end; ++match)
			if (!contains(layer->sees, (*match)[1]))
				violations.push_back(path + ": layer " + layer->name + " sees " + listOf(layer->sees) +
				                     ", so it must not link " + match->str());
	}
	return violations;
}

std::vector<std::string> clockViolations(const SourceTree& tree, const std::vector<Layer>& layers)
{
	static const std::regex kClock(R"((Clock|_clock)::now|\bmrpt::system::now\b|\bCTicTac\b|\bCTimeLogger\b)");
	std::vector<std::string> violations;
	for (const auto& [path, text] : tree)
	{
		const Layer* layer = layerOf(layers, path);
		if (!isCode(path) || layer == nullptr || !layer->pure) continue;
		const std::string code = withoutComments(text);
		for (std::sregex_iterator match(code.begin(), code.end(), kClock), end; match != end; ++match)
			violations.push_back(path + ":" +
			                     std::to_string(1 + std::count(code.begin(), code.begin() + match->position(), '\n')) +
			                     ": layer " + layer->name + " reads no clock: " + match->str());
	}
	return violations;
}

std::vector<std::string> includeCycles(const SourceTree& tree)
{
	return CycleSearch(tree).run();
}

std::vector<std::string> shapeViolations(const SourceTree& tree, int max_lines)
{
	std::vector<std::string> violations;
	for (const auto& [path, text] : tree)
	{
		if (!isCode(path)) continue;
		const auto lines = std::ranges::count(text, '\n');
		if (lines > max_lines)
			violations.push_back(path + ": " + std::to_string(lines) + " lines, more than " +
			                     std::to_string(max_lines));
		if (!path.ends_with(".h")) continue;
		if (openingComment(text).find_first_of(".:") == std::string::npos)
			violations.push_back(path + ": does not open with a sentence that says what the file is for");
		if (withoutComments(text).find("#pragma once") == std::string::npos)
			violations.push_back(path + ": lacks #pragma once");
	}
	return violations;
}
}  // namespace explore::test
