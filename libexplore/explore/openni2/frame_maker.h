// Turns raw depth into the frames that the explorer gets, by the same way as those of a rawlog.
#pragma once

#include <explore/openni2/raw_depth.h>
#include <explore/sources/depth_conversion.h>
#include <explore/sources/source.h>
#include <explore/sources/warn_once.h>

namespace explore::openni2
{
/** The label of `config`, else "OPENNI2"; the mount that `config` gives, else the identity. */
ScanHeader headerOf(const SourceConfig& config);

/** When the first frame of a recording was taken, for its clock has no date: 2014-05-13 16:53:20 UTC. */
mrpt::Clock::time_point recordingStart();

class FrameMaker
{
public:
	/** `logger` outlives it. Throws ConfigError as DepthConverter does. */
	FrameMaker(const SourceConfig& config, mrpt::system::COutputLogger& logger);

	/** Masked and corrected. No value, but a warning and a count, for one that cannot be used. Throws ConfigError. */
	std::optional<DepthFrame> make(const RawDepth& raw, mrpt::Clock::time_point time);
	/** Takes back the frame that was made last: nobody is given it. */
	void takeBack() { --m_report.frames; }
	/** Says that there is none: neither image nor points. */
	DepthFrame makeEmpty(mrpt::Clock::time_point time);
	/** Counts a frame that cannot be used, and says why, once each. */
	void skip(const std::string& why);

	[[nodiscard]] const SourceReport& report() const { return m_report; }

private:
	SourceConfig m_config;
	WarnOnce m_warn;
	DepthConverter m_converter;
	ScanHeader m_header;
	SourceReport m_report;
};
}  // namespace explore::openni2
