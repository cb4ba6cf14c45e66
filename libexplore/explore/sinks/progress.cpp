#include <explore/sinks/progress.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace explore
{
namespace
{
constexpr double kTerminalPeriod_s = 0.1;
constexpr double kPlainPeriod_s = 5.0;
constexpr std::string_view kEraseLine = "\r\033[K";

std::string timeLeft(double share, double elapsed_s)
{
	const long left_s = std::lround(elapsed_s * (1.0 - share) / share);
	return mrpt::format("  left %ld:%02ld", left_s / 60, left_s % 60);
}
}  // namespace

std::string progressText(const Progress& progress, double rate_hz, double elapsed_s)
{
	std::string text = mrpt::format("frame %zu", progress.frames);
	if (progress.share) text += mrpt::format("  %.0f %%", 100.0 * std::clamp(*progress.share, 0.0, 1.0));
	if (rate_hz > 0.0) text += mrpt::format("  %.0f Hz", rate_hz);
	text += mrpt::format("  doors %zu", progress.doors);
	if (progress.known_free_m2) text += mrpt::format("  known %.0f m2", *progress.known_free_m2);
	if (!progress.goal.empty()) text.append("  goal ").append(progress.goal);
	if (progress.share && *progress.share > 0.0) text += timeLeft(std::min(*progress.share, 1.0), elapsed_s);
	return text;
}

StatusLine::StatusLine(Style style, Write write) : m_style(style), m_write(std::move(write)) {}

bool StatusLine::isDue(double elapsed_s) const
{
	const double period_s = m_style == Style::terminal ? kTerminalPeriod_s : kPlainPeriod_s;
	return m_style != Style::silent && elapsed_s - m_shown_at_s >= period_s;
}

void StatusLine::update(const Progress& progress, double elapsed_s)
{
	if (!isDue(elapsed_s)) return;
	const double rate_hz = static_cast<double>(progress.frames - m_shown_frames) / (elapsed_s - m_shown_at_s);
	const std::string text = progressText(progress, rate_hz, elapsed_s);
	m_shown_at_s = elapsed_s;
	m_shown_frames = progress.frames;
	if (m_style == Style::plain)
	{
		m_write(text + '\n');
		return;
	}
	m_write(std::string(kEraseLine) + text);
	m_standing = true;
}

void StatusLine::log(std::string_view line)
{
	erase();
	m_write(std::string(line) + '\n');
}

void StatusLine::finish()
{
	erase();
}

void StatusLine::erase()
{
	if (std::exchange(m_standing, false)) m_write(kEraseLine);
}
}  // namespace explore
