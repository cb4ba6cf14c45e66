#include <explore/config/field_value.h>
#include <explore/config/ini.h>
#include <explore/core/errors.h>

#include <sstream>

namespace explore
{
namespace
{
constexpr std::size_t kWidth = 100;
constexpr std::string_view kIntroduction =
    "Complete configuration in MRPT's config format. Only // may trail a value; # begins a comment at the start of a "
    "line. A key that is left out keeps its default. Lengths in metres, times in seconds, angles in degrees.";

/** Writes `text` as comment lines of at most kWidth columns. */
void writeComment(std::ostream& ini, std::string_view text)
{
	std::istringstream words{std::string(text)};
	std::size_t column = 0;
	for (std::string word; words >> word; column += 1 + word.size())
	{
		const bool is_full = column + 1 + word.size() > kWidth;
		if (column == 0 || is_full)
		{
			ini << (column == 0 ? "#" : "\n#");
			column = 1;
		}
		ini << ' ' << word;
	}
	ini << '\n';
}

void writeField(std::ostream& ini, const Field& field)
{
	try
	{
		const std::string value = formatValue(field);
		const std::string end_of_help = field.help.ends_with('.') ? " " : ". ";
		writeComment(ini, field.help + end_of_help + "Accepted: " + acceptedValues(field) + ".");
		ini << field.key << (value.empty() ? " =" : " = ") << value << '\n';
	}
	catch (const BadValue& error)
	{
		throw ConfigError("[" + field.section + "] " + field.key + " cannot be written to an ini file: it " +
		                  error.what());
	}
}
}  // namespace

std::string dumpIni(const DescribeFields& fields)
{
	std::ostringstream ini;
	writeComment(ini, kIntroduction);
	for (const auto& section : listSections(fields))
	{
		ini << '\n';
		writeComment(ini, section.help);
		ini << '[' << section.name << "]\n";
		for (const auto& field : section.fields)
		{
			ini << '\n';
			writeField(ini, field);
		}
	}
	return ini.str();
}
}  // namespace explore
