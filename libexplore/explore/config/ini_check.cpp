#include <explore/config/field_value.h>
#include <explore/config/ini_check.h>
#include <explore/config/ini_text.h>
#include <explore/config/suggestions.h>

#include <algorithm>
#include <cstddef>
#include <set>

namespace explore
{
std::vector<IniProblem> IniChecker::checkDocument(const IniDocument& document)
{
	std::vector<IniProblem> problems = document.problems;
	const auto note = [&](int line, const std::string& what)
	{
		if (!what.empty()) problems.push_back({line, what});
	};
	std::map<const Field*, int> line_of;
	std::set<int> broken_lines;  // what is wrong with those is said already
	for (const auto& problem : document.problems) broken_lines.insert(problem.line);
	for (const auto& header : document.sections) note(header.line, checkHeader(header));
	for (const auto& entry : document.entries)
		if (!broken_lines.contains(entry.line)) note(entry.line, checkEntry(entry, line_of));
	std::stable_sort(problems.begin(), problems.end(),
	                 [](const IniProblem& a, const IniProblem& b) { return a.line < b.line; });
	return problems;
}

std::string IniChecker::checkHeader(const IniHeader& header) const
{
	if (findSection(m_sections, header.name) != nullptr) return "";
	return "unknown section [" + shown(header.name) + "]; " + suggestSection(m_sections, header.name);
}

std::string IniChecker::checkEntry(const IniEntry& entry, std::map<const Field*, int>& line_of)
{
	const std::string assignment = shown(entry.key) + " = " + inQuotes(entry.value);
	if (entry.section.empty()) return assignment + ": stands in no section" + suggestion("", entry.key);
	const Section* const section = findSection(m_sections, entry.section);
	if (section == nullptr) return "";  // said once, at the section's head

	const std::string place = "[" + section->name + "] " + assignment + ": ";
	const Field* const field = findField(*section, entry.key);
	if (field == nullptr) return place + "unknown key" + suggestion(section->name, entry.key);
	const auto [first, is_first] = line_of.emplace(field, entry.line);
	if (!is_first) return place + "the key was given before, in line " + std::to_string(first->second);
	const std::string reason = setValue(*field, entry.value);
	return reason.empty() ? "" : place + reason;
}

std::string IniChecker::checkOverride(const std::string& assignment)
{
	const std::size_t equals = std::min(assignment.find('='), assignment.size());
	const std::size_t dot = assignment.substr(0, equals).find('.');
	if (equals == assignment.size() || dot == std::string::npos) return "accepted: section.key=value";

	const std::string section_name(trimmed(std::string_view(assignment).substr(0, dot)));
	const std::string key(trimmed(std::string_view(assignment).substr(dot + 1, equals - dot - 1)));
	const Section* const section = findSection(m_sections, section_name);
	if (section == nullptr) return "unknown section; " + suggestSection(m_sections, section_name);
	const Field* const field = findField(*section, key);
	if (field == nullptr) return "unknown key" + suggestion(section_name, key);
	return setValue(*field, std::string(trimmed(std::string_view(assignment).substr(equals + 1))));
}

std::string IniChecker::suggestion(const std::string& section, const std::string& key)
{
	constexpr int kMost = 100;  // a file with more unknown keys is no typo but another kind of file
	return ++m_suggestions > kMost ? "" : "; " + suggestKey(m_sections, section, key);
}

std::string IniChecker::setValue(const Field& field, const std::string& text)
{
	try
	{
		m_values.insert_or_assign({field.section, field.key}, parseValue(field, text));
		return "";
	}
	catch (const BadValue& error)
	{
		return std::string(error.what()) + "; accepted: " + acceptedValues(field);
	}
}
}  // namespace explore
