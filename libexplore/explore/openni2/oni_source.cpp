#include <explore/openni2/oni_source.h>

namespace explore::openni2
{
mrpt::Clock::time_point RecordedTime::of(const RawDepth& raw)
{
	if (!m_first_us) m_first_us = raw.device_time_us;
	const auto since_us = static_cast<std::int64_t>(raw.device_time_us - *m_first_us);
	return recordingStart() + std::chrono::duration_cast<mrpt::Clock::duration>(std::chrono::microseconds(since_us));
}

OniSource::OniSource(const SourceConfig& config, mrpt::system::COutputLogger& logger)
    : m_maker(config, logger), m_file(config.oni, config.openni2), m_path(config.oni)
{
}

std::optional<DepthFrame> OniSource::next()
{
	while (true) try
		{
			const auto raw = m_file.next();
			if (!raw) return std::nullopt;
			if (auto frame = m_maker.make(*raw, m_time.of(*raw))) return frame;
		}
		catch (const BadFrame& why)
		{
			m_maker.skip(why.what());
			if (m_bad++ == 0) m_first_bad = why.what();
		}
}

SourceReport OniSource::report() const
{
	SourceReport report = m_maker.report();
	report.kind = "oni";
	report.path = m_path;
	report.damage = m_file.damage();
	if (!report.damage.empty())
		report.lost_objects = static_cast<std::size_t>(m_file.frameCount() - m_file.framesRead());
	if (m_bad == 0) return report;
	report.lost_objects += m_bad;
	report.damage += (report.damage.empty() ? "" : "; ") + std::to_string(m_bad) +
	                 " frames cannot be used, the first because: " + m_first_bad;
	return report;
}

std::optional<double> OniSource::progress() const
{
	return static_cast<double>(m_file.framesRead()) / m_file.frameCount();
}
}  // namespace explore::openni2
