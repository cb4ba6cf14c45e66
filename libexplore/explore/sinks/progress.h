// What a person sees while the program runs: one rewritten line on a terminal, plain lines elsewhere.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace explore
{
/** Where a run stands. */
struct Progress
{
	std::size_t frames = 0;
	std::optional<double> share;                         ///< of the input, 0–1
	std::size_t doors = 0;                               ///< confirmed ones, or in view where nothing is remembered
	std::string_view goal = {};                          ///< kind of the present one; empty = none
	std::optional<double> known_free_m2 = std::nullopt;  ///< floor known to be free, where there is a map
};

/** "frame 120  30 %  85 Hz  doors 1  known 42 m2  goal door  left 0:12"; `rate_hz` is the present speed, `elapsed_s`
 * the time since the start. What is not known is left out. */
std::string progressText(const Progress& progress, double rate_hz, double elapsed_s);

/** Status lines and log lines that share one stream without tearing each other apart. */
class StatusLine
{
public:
	using Write = std::function<void(std::string_view)>;

	enum class Style
	{
		terminal,  ///< one line, rewritten ten times a second
		plain,     ///< a line every five seconds
		silent     ///< none; log lines only
	};

	StatusLine(Style style, Write write);

	/** Whether it is time to show something; `elapsed_s` since the start never falls. */
	[[nodiscard]] bool isDue(double elapsed_s) const;
	/** Shows `progress` when it is time to. */
	void update(const Progress& progress, double elapsed_s);
	/** A line of the log, without newline; stands above the status line on a terminal. */
	void log(std::string_view line);
	/** Ends a status line that still stands. */
	void finish();

private:
	void erase();

	Style m_style;
	Write m_write;
	double m_shown_at_s = 0;
	std::size_t m_shown_frames = 0;
	bool m_standing = false;
};
}  // namespace explore
