#include <explore/config/ini_document.h>
#include <explore/config/ini_text.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace explore
{
namespace
{
class Reader
{
public:
	explicit Reader(std::vector<IniProblem> problems) { m_document.problems = std::move(problems); }

	void readLine(std::string_view line, int number)
	{
		m_line = number;
		if (line.empty()) return;
		if (line.front() == '[')
			readHeader(line);
		else
			readEntry(line);
	}

	IniDocument take()
	{
		std::stable_sort(m_document.problems.begin(), m_document.problems.end(),
		                 [](const IniProblem& a, const IniProblem& b) { return a.line < b.line; });
		return std::move(m_document);
	}

private:
	void readHeader(std::string_view line)
	{
		const std::size_t end = line.find(']');
		const auto name = trimmed(line.substr(1, std::min(end, line.size()) - 1));
		m_section = name;
		if (end == std::string_view::npos) return problem(line, "is a section without its closing ]");
		if (name.empty()) return problem(line, "is a section without a name");
		m_document.sections.push_back({m_section, m_line});

		const auto rest = trimmed(line.substr(end + 1));
		const bool is_comment = rest.starts_with('#') || rest.starts_with(';') || rest.starts_with("//");
		if (!rest.empty() && !is_comment) problem(rest, "stands behind a section name, where MRPT ignores it");
	}

	void readEntry(std::string_view line)
	{
		const std::size_t equals = line.find('=');
		if (equals == std::string_view::npos) return problem(line, "is neither [section] nor key = value");
		const auto key = trimmed(line.substr(0, equals));
		if (key.empty()) return problem(line, "has no key in front of the =");
		m_document.entries.push_back(
		    {m_section, std::string(key), std::string(trimmed(line.substr(equals + 1))), m_line});
	}

	void problem(std::string_view text, const std::string& what)
	{
		m_document.problems.push_back({m_line, inQuotes(text) + " " + what});
	}

	IniDocument m_document;
	std::string m_section;
	int m_line = 0;
};
}  // namespace

IniDocument parseIni(const std::string& name, const std::string& text)
{
	auto [lines, problems] = resolveIni(name, text);
	Reader reader(std::move(problems));
	for (std::size_t i = 0; i < lines.size(); ++i) reader.readLine(trimmed(lines[i]), static_cast<int>(i) + 1);
	return reader.take();
}
}  // namespace explore
