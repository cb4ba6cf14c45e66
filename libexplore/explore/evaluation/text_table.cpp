#include <explore/evaluation/text_table.h>
#include <mrpt/core/format.h>

#include <algorithm>

namespace explore::evaluation
{
namespace
{
/** Columns that the text takes on a terminal: bytes that continue a UTF-8 character take none. */
std::size_t widthOf(const std::string& text)
{
	return static_cast<std::size_t>(
	    std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}
}  // namespace

TextTable::TextTable(const std::vector<std::string>& titles)
{
	std::vector<std::string> shown;
	for (const std::string& title : titles)
	{
		m_left.push_back(title.starts_with('<'));
		shown.push_back(m_left.back() ? title.substr(1) : title);
	}
	row(std::move(shown));
}

void TextTable::row(std::vector<std::string> cells)
{
	cells.resize(m_left.size());
	m_rows.push_back(std::move(cells));
}

std::string TextTable::text() const
{
	std::vector<std::size_t> widths(m_left.size(), 0);
	for (const auto& cells : m_rows)
		for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], widthOf(cells[i]));
	std::string text;
	for (const auto& cells : m_rows)
	{
		std::string line;
		for (std::size_t i = 0; i < cells.size(); ++i)
		{
			const std::string padding(widths[i] - widthOf(cells[i]), ' ');
			line += "  " + (m_left[i] ? cells[i] + padding : padding + cells[i]);
		}
		line.erase(line.find_last_not_of(' ') + 1);
		text.append(line).append("\n");
	}
	return text;
}

std::string withInterval(const std::optional<double>& value, const std::optional<Interval>& interval,
                         const char* format)
{
	if (!value) return "-";
	std::string text = mrpt::format(format, *value);
	if (!interval) return text;
	return text.append(" [")
	    .append(mrpt::format(format, interval->low))
	    .append(", ")
	    .append(mrpt::format(format, interval->high))
	    .append("]");
}
}  // namespace explore::evaluation
