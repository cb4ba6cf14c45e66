#include "apps/document_commands.h"

#include "support/test_files.h"

#include <algorithm>
#include <optional>
#include <regex>

namespace explore::test
{
namespace
{
namespace fs = std::filesystem;

bool isCommand(const std::string& line)
{
	static const std::regex begin(
	    R"(^(explore-(mrpt|rawlog|eval)( |$)|(\./|apps/|doc/examples/|tests/support/|\.ci/|(/usr/bin/)?python3 |cp |head |mkdir |)"
	    R"(sudo |apt|cmake |ctest |g\+\+ |rosbag|rawlog-grabber )))");
	static const std::regex option(R"( --[a-z])");
	return std::regex_search(line, begin) || std::regex_search(line, option);
}

/** Goes through a page line by line and gathers its steps. */
class PageReader
{
public:
	explicit PageReader(std::string page) : m_page(std::move(page)) {}

	void add(const std::string& line)
	{
		++m_line;
		if (line.starts_with("<!--")) m_comment = true;
		const bool passed_over = m_comment;
		if (line.ends_with("-->")) m_comment = false;
		if (passed_over) return;
		if (line.starts_with("```"))
			fence(line.substr(3));
		else if (m_file)
			m_file->text += line + "\n";
		else if (m_shell || (!m_fenced && line.starts_with("    ")))
			shellLine(line);
		else
			prose(line);
	}

	[[nodiscard]] std::vector<PageStep> steps() const { return m_steps; }

private:
	void fence(const std::string& language)
	{
		m_joins = false;
		if (m_fenced)
		{
			if (m_file) m_steps.push_back(*m_file);
			m_file.reset();
			m_fenced = m_shell = false;
			return;
		}
		m_fenced = true;
		m_shell = language.empty() || language == "sh";
		if (!m_shell && !m_named.empty()) m_file = PageStep{m_page, m_line, {}, m_named};
		m_named.clear();
	}

	void prose(const std::string& line)
	{
		m_joins = false;
		if (line.empty()) return;
		static const std::regex name("`([^` ]+)`:$");
		std::smatch match;
		m_named = std::regex_search(line, match, name) ? match[1].str() : std::string();
	}

	void shellLine(const std::string& line)
	{
		std::string text = std::regex_replace(line, std::regex(R"(^\s*(\$ )?|\s+$)"), "");
		const bool goes_on = m_joins || (text.starts_with("[") && !m_steps.empty() && isSynopsis(m_steps.back().text));
		if (!goes_on && !isCommand(text)) return;
		m_joins = text.ends_with("\\");
		if (m_joins) text.pop_back();
		if (goes_on)
			m_steps.back().text += " " + text;
		else
			m_steps.push_back({m_page, m_line, text, {}});
	}

	std::string m_page, m_named;
	std::vector<PageStep> m_steps;
	std::optional<PageStep> m_file;
	int m_line = 0;
	bool m_comment = false, m_fenced = false, m_shell = false, m_joins = false;
};
}  // namespace

std::vector<std::string> documentPages()
{
	std::vector<std::string> pages{"README.md", "rawlogs/README.md"};
	for (const auto& entry : fs::directory_iterator(fs::path(EXPLORE_SOURCE_DIR) / "doc"))
		if (entry.path().extension() == ".md") pages.push_back("doc/" + entry.path().filename().string());
	std::sort(pages.begin(), pages.end());
	return pages;
}

std::vector<PageStep> stepsOf(const std::string& page)
{
	PageReader reader(page);
	for (const std::string& line : linesOf(readFile(fs::path(EXPLORE_SOURCE_DIR) / page))) reader.add(line);
	return reader.steps();
}

bool isSynopsis(const std::string& command)
{
	const std::string typed = command.substr(0, command.find(" #"));
	return typed.find(" [") != std::string::npos || typed.find(" | ") != std::string::npos ||
	       typed.find("...") != std::string::npos;
}

std::vector<std::string> longOptionsIn(const std::string& text)
{
	static const std::regex option(R"((^|[\s\[,])(--[a-z][a-z0-9-]*))");
	std::vector<std::string> found;
	for (std::sregex_iterator match(text.begin(), text.end(), option), end; match != end; ++match)
		found.push_back((*match)[2]);
	return found;
}
}  // namespace explore::test
