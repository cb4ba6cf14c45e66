// Rows of comma-separated values as RFC 4180 has them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace explore::evaluation
{
class CsvRow
{
public:
	/** Quoted where it must be; line breaks become blanks, so that a row is a line. */
	CsvRow& text(std::string_view value);
	/** With at most four decimals; empty where there is no value. */
	CsvRow& number(const std::optional<double>& value);
	CsvRow& count(std::size_t value);
	/** 1 or 0; empty where there is no value. */
	CsvRow& flag(const std::optional<bool>& value);
	CsvRow& blanks(int count);

	/** The row with its line end. */
	[[nodiscard]] std::string line() const { return m_text + "\n"; }

private:
	void next();

	std::string m_text;
	bool m_first = true;
};
}  // namespace explore::evaluation
