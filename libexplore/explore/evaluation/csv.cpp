#include <explore/evaluation/csv.h>

#include <array>
#include <charconv>
#include <cmath>

namespace explore::evaluation
{
void CsvRow::next()
{
	if (!m_first) m_text += ',';
	m_first = false;
}

CsvRow& CsvRow::text(std::string_view value)
{
	next();
	const bool quoted = value.find_first_of(",\"\r\n") != std::string_view::npos;
	if (quoted) m_text += '"';
	for (const char c : value)
	{
		if (c == '"') m_text += '"';
		m_text += c == '\n' || c == '\r' ? ' ' : c;
	}
	if (quoted) m_text += '"';
	return *this;
}

CsvRow& CsvRow::number(const std::optional<double>& value)
{
	constexpr double kSteps = 1e4;
	next();
	if (value)
	{
		const double shown = std::round(*value * kSteps) / kSteps;
		std::array<char, 400> digits{};  // the longest double, written out, has fewer
		const auto end = std::to_chars(digits.begin(), digits.end(), shown == 0.0 ? 0.0 : shown,  // never −0
		                               std::chars_format::fixed);
		m_text.append(digits.begin(), end.ptr);
	}
	return *this;
}

CsvRow& CsvRow::count(std::size_t value)
{
	next();
	m_text += std::to_string(value);
	return *this;
}

CsvRow& CsvRow::flag(const std::optional<bool>& value)
{
	next();
	if (value) m_text += *value ? '1' : '0';
	return *this;
}

CsvRow& CsvRow::blanks(int count)
{
	for (int i = 0; i < count; ++i) next();
	return *this;
}
}  // namespace explore::evaluation
