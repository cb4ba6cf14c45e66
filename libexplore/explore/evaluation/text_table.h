// Columns of text that line up.
#pragma once

#include <explore/evaluation/scene_bootstrap.h>

#include <optional>
#include <string>
#include <vector>

namespace explore::evaluation
{
class TextTable
{
public:
	/** Columns whose title begins with '<' (not shown) stand left, all others right. */
	explicit TextTable(const std::vector<std::string>& titles);

	void row(std::vector<std::string> cells);
	[[nodiscard]] bool empty() const { return m_rows.size() < 2; }
	/** Every line indented by two blanks; no blanks at line ends. */
	[[nodiscard]] std::string text() const;

private:
	std::vector<bool> m_left;
	std::vector<std::vector<std::string>> m_rows;
};

/** A value and its interval, both in the same printf format; "-" without a value. */
std::string withInterval(const std::optional<double>& value, const std::optional<Interval>& interval,
                         const char* format);
}  // namespace explore::evaluation
