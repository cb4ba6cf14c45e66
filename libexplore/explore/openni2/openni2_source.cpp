#include <explore/openni2/openni2_source.h>

#include <algorithm>

namespace explore::openni2
{
namespace
{
using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLongest = 500ms;
constexpr std::uint64_t kDrift_us = 20;
constexpr std::chrono::seconds kAnew = 1s;

mrpt::Clock::duration microseconds(std::uint64_t count)
{
	return std::chrono::duration_cast<mrpt::Clock::duration>(std::chrono::microseconds(count));
}
}  // namespace

bool HostTime::staysLate(mrpt::Clock::duration late, mrpt::Clock::time_point arrived)
{
	if (late <= kOldestUsed)
		m_late_since.reset();
	else if (!m_late_since)
		m_late_since = arrived;
	return m_late_since && arrived - *m_late_since > kAnew;
}

mrpt::Clock::time_point HostTime::taken(const RawDepth& raw)
{
	const mrpt::Clock::time_point device(microseconds(raw.device_time_us));
	const mrpt::Clock::duration offset = raw.arrived - device, apart = offset - m_offset;
	const bool other_clock = raw.connection != m_connection || apart > kAnew || apart < -kAnew;
	const bool anew = staysLate(apart, raw.arrived) || other_clock;
	if (anew) m_late_since.reset();
	m_connection = raw.connection;
	m_offset = anew ? offset : std::min(offset, m_offset + microseconds(kDrift_us));
	return device + m_offset;
}

mrpt::Clock::time_point HostTime::later(mrpt::Clock::time_point time)
{
	m_last = std::max(time, m_last + microseconds(1));
	return m_last;
}

Openni2Source::Openni2Source(const SourceConfig& config, mrpt::system::COutputLogger& logger)
    : m_logger(logger), m_maker(config, logger), m_camera(config.openni2), m_device(config.openni2.device)
{
}

std::optional<DepthFrame> Openni2Source::next()
{
	const auto due = steady_clock::now() + kLongest;
	for (auto now = steady_clock::now(); now < due; now = steady_clock::now())
	{
		const auto raw = m_camera.take(std::chrono::ceil<std::chrono::milliseconds>(due - now));
		passOnMessages();
		if (!raw) break;
		if (auto frame = used(*raw)) return frame;
	}
	return m_maker.makeEmpty(m_time.later(mrpt::Clock::now()));
}

/** Its frame, unless it is too old by now or cannot be used. */
std::optional<DepthFrame> Openni2Source::used(const RawDepth& raw)
{
	const mrpt::Clock::time_point taken = m_time.taken(raw);
	auto frame = m_maker.make(raw, m_time.later(taken));
	if (!frame) return std::nullopt;
	const mrpt::Clock::duration age = mrpt::Clock::now() - taken;
	if (age > kOldestUsed)
	{
		m_maker.takeBack();
		++m_too_old;
		return std::nullopt;
	}
	const std::chrono::duration<double, std::milli> age_ms = age;
	m_oldest_ms = std::max(m_oldest_ms.value_or(0.0), age_ms.count());
	return frame;
}

void Openni2Source::passOnMessages()
{
	for (const std::string& text : m_camera.takeTold()) m_logger.logStr(mrpt::system::LVL_WARN, text);
}

SourceReport Openni2Source::report() const
{
	SourceReport report = m_maker.report();
	const Mailbox::Counts counts = m_camera.counts();
	report.path = m_device;
	report.dropped_frames = counts.dropped + m_too_old;
	report.oldest_frame_ms = m_oldest_ms;
	report.skipped_frames += counts.bad;
	return report;
}
}  // namespace explore::openni2
