#include <explore/openni2/openni2_source.h>

#include <algorithm>

namespace explore::openni2
{
namespace
{
using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLongest = 500ms;

mrpt::Clock::duration microseconds(std::uint64_t count)
{
	return std::chrono::duration_cast<mrpt::Clock::duration>(std::chrono::microseconds(count));
}
}  // namespace

mrpt::Clock::time_point HostTime::of(const RawDepth& raw)
{
	const mrpt::Clock::time_point device(microseconds(raw.device_time_us));
	const auto apart = raw.arrived - (device + m_offset);
	if (raw.connection != m_connection || apart > 1s || apart < 0s)
	{
		m_connection = raw.connection;
		m_offset = raw.arrived - device;
	}
	return later(device + m_offset);
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
		if (auto frame = m_maker.make(*raw, m_time.of(*raw))) return frame;
	}
	return m_maker.makeEmpty(m_time.later(mrpt::Clock::now()));
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
	report.dropped_frames = counts.dropped;
	report.skipped_frames += counts.bad;
	return report;
}
}  // namespace explore::openni2
