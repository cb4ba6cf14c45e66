#include "source_tree.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace explore::test
{
namespace
{
bool isSource(const std::filesystem::path& path)
{
	const std::string extension = path.extension().string();
	return extension == ".h" || extension == ".cpp" || extension == ".cmake";
}

/** Walks over C++ text and keeps code, with what lies in comments and literals replaced by blanks. */
class CommentStripper
{
public:
	explicit CommentStripper(std::string_view text) : m_text(text) { m_code.reserve(text.size()); }

	std::string run()
	{
		while (m_at < m_text.size()) next();
		return std::move(m_code);
	}

private:
	[[nodiscard]] bool sees(std::string_view what) const { return m_text.substr(m_at, what.size()) == what; }

	void next()
	{
		const char previous = m_at == 0 ? '\n' : m_text[m_at - 1];
		if (sees("//"))
			blankUntil("\n");
		else if (sees("/*"))
			blankPast("*/", 2);
		else if (sees("R\"") && !isWordCharacter(previous))
			rawString();
		else if (m_text[m_at] == '"' && !inInclude())
			literal('"');
		else if (m_text[m_at] == '\'' && !isWordCharacter(previous))  // 1'000 is a number
			literal('\'');
		else
			m_code += m_text[m_at++];
	}

	static bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

	[[nodiscard]] bool inInclude() const
	{
		const std::string line = m_code.substr(m_code.rfind('\n') + 1);
		return std::regex_search(line, std::regex(R"(^\s*#\s*include\b)"));
	}

	void blankTo(std::size_t end)
	{
		for (; m_at < std::min(end, m_text.size()); ++m_at) m_code += m_text[m_at] == '\n' ? '\n' : ' ';
	}

	void blankUntil(std::string_view end) { blankTo(m_text.find(end, m_at)); }

	void blankPast(std::string_view end, std::size_t opening_length)
	{
		const std::size_t found = m_text.find(end, m_at + opening_length);
		blankTo(found == std::string_view::npos ? found : found + end.size());
	}

	void rawString()
	{
		const std::size_t open = m_text.find('(', m_at);
		if (open == std::string_view::npos) return blankTo(open);
		const std::string delimiter(m_text.substr(m_at + 2, open - m_at - 2));
		blankPast(")" + delimiter + "\"", open - m_at);
	}

	void literal(char quote)
	{
		std::size_t end = m_at + 1;
		while (end < m_text.size() && m_text[end] != quote && m_text[end] != '\n') end += m_text[end] == '\\' ? 2 : 1;
		blankTo(end == std::string_view::npos ? end : end + 1);
	}

	std::string_view m_text;
	std::size_t m_at = 0;
	std::string m_code;
};

Include includeFrom(const std::string& rest, int line)
{
	const char first = rest.empty() ? ' ' : rest.front();
	const std::size_t close = rest.find(first == '<' ? '>' : '"', 1);
	if ((first != '<' && first != '"') || close == std::string::npos) return {rest, Include::Form::computed, line};
	return {rest.substr(1, close - 1), first == '<' ? Include::Form::angled : Include::Form::quoted, line};
}
}  // namespace

SourceTree readSources(const std::filesystem::path& root, const std::vector<std::string>& folders)
{
	SourceTree tree;
	for (const std::string& folder : folders)
		for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder))
		{
			if (!entry.is_regular_file() || !isSource(entry.path())) continue;
			std::ifstream file(entry.path(), std::ios::binary);
			tree[std::filesystem::relative(entry.path(), root).generic_string()] =
			    std::string(std::istreambuf_iterator<char>(file), {});
		}
	return tree;
}

std::string withoutComments(std::string_view text)
{
	return CommentStripper(text).run();
}

std::vector<Include> includesOf(std::string_view text)
{
	static const std::regex kDirective(R"(^\s*#\s*include\b\s*(.*?)\s*$)");
	std::vector<Include> includes;
	std::istringstream lines(withoutComments(text));
	int number = 0;
	for (std::string line; std::getline(lines, line);)
	{
		++number;
		if (std::smatch match; std::regex_match(line, match, kDirective))
			includes.push_back(includeFrom(match[1].str(), number));
	}
	return includes;
}

std::string resolve(const SourceTree& tree, const std::string& from, const Include& include)
{
	const auto normal = [](const std::filesystem::path& path) { return path.lexically_normal().generic_string(); };
	std::vector<std::string> candidates;
	if (include.form == Include::Form::quoted)
		candidates = {normal(std::filesystem::path(from).parent_path() / include.target)};
	else if (include.form == Include::Form::angled)
		candidates = {normal("libexplore/" + include.target), normal("apps/" + include.target)};
	const auto found = std::ranges::find_if(candidates, [&](const std::string& path) { return tree.contains(path); });
	return found == candidates.end() ? std::string() : *found;
}
}  // namespace explore::test
