// Compares what was written in an ini file with the fields that there are, and keeps the values that are right.
#pragma once

#include <explore/config/field_list.h>
#include <explore/config/ini_document.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace explore
{
/** Values by (section, key), both spelled as in the field list. */
using FieldValues = std::map<std::pair<std::string, std::string>, FieldValue>;

class IniChecker
{
public:
	explicit IniChecker(const DescribeFields& fields) : m_sections(listSections(fields)) {}

	/** What is wrong with the document, in the order of its lines. Values that are right join values(). */
	std::vector<IniProblem> checkDocument(const IniDocument& document);

	/** What is wrong with "section.key=value", or "". A value that is right joins values(). */
	std::string checkOverride(const std::string& assignment);

	[[nodiscard]] const FieldValues& values() const { return m_values; }

private:
	std::string checkHeader(const IniHeader& header) const;
	std::string checkEntry(const IniEntry& entry, std::map<const Field*, int>& line_of);
	std::string suggestion(const std::string& section, const std::string& key);
	std::string setValue(const Field& field, const std::string& text);

	std::vector<Section> m_sections;
	FieldValues m_values;
	int m_suggestions = 0;
};
}  // namespace explore
