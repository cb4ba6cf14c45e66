#include <explore/config/field_value.h>
#include <explore/config/ini.h>

#include <sstream>

namespace explore
{
namespace
{
constexpr std::string_view kPageStart =
    "# Ini reference\n\n"
    "Written by the program from the same field list that loads and checks the files; `explore-mrpt --dump-config`\n"
    "prints it as a complete ini. Files are MRPT config files: `@define`, `${}`, `$env{}` and `$eval{}` work "
    "(`$eval{}`\n"
    "gives seven digits), a backslash at its end continues a line, and only `//` may trail a value. Letter case of\n"
    "sections and keys does not matter. A key that is left out keeps its default.\n";

/** `text` as it has to stand in a table cell. */
std::string cell(std::string_view text)
{
	std::string escaped;
	for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
	return escaped;
}

void writeRow(std::ostream& text, const Field& field)
{
	const std::string value = formatValue(field);
	text << "| `" << field.key << "` | " << (value.empty() ? "(empty)" : '`' + cell(value) + '`') << " | "
	     << cell(acceptedValues(field)) << " | " << cell(field.help) << " |\n";
}
}  // namespace

std::string iniReference(const DescribeFields& fields)
{
	std::ostringstream text;
	text << kPageStart;
	for (const auto& section : listSections(fields))
	{
		text << "\n## [" << section.name << "]\n\n" << section.help << "\n\n";
		text << "| key | default | accepted | meaning |\n|---|---|---|---|\n";
		for (const auto& field : section.fields) writeRow(text, field);
	}
	return text.str();
}
}  // namespace explore
