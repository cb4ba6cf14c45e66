#include <explore/config/ini_text.h>
#include <mrpt/system/string_utils.h>

#include <algorithm>

namespace explore
{
bool isBlank(char c)
{
	return c == ' ' || c == '\t';
}

bool isControl(unsigned char c)
{
	return (c < 0x20 && c != '\t') || c == 0x7f;
}

std::string_view trimmed(std::string_view text)
{
	constexpr std::string_view kBlanks = " \t";
	const std::size_t first = text.find_first_not_of(kBlanks);
	if (first == std::string_view::npos) return {};
	return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool sameName(std::string_view a, std::string_view b)
{
	return a.size() == b.size() && mrpt::system::strCmpI(std::string(a), std::string(b));
}

std::size_t findComment(std::string_view text, std::string_view mark, std::size_t start)
{
	for (std::size_t at = text.find(mark, start); at != std::string_view::npos; at = text.find(mark, at + 1))
		if (at == start || isBlank(text[at - 1])) return at;
	return std::string_view::npos;
}

std::string_view withoutRemark(std::string_view value)
{
	return trimmed(value.substr(0, value.find("//")));
}

std::string placeOf(const std::string& file, int line)
{
	return file + ":" + std::to_string(line) + ": ";
}

std::string shown(std::string_view text)
{
	constexpr std::size_t kMost = 60;
	std::string cut(text.substr(0, kMost));
	std::replace_if(cut.begin(), cut.end(), isControl, '.');
	return text.size() > kMost ? cut + "..." : cut;
}

std::string inQuotes(std::string_view text)
{
	return '"' + shown(text) + '"';
}
}  // namespace explore
