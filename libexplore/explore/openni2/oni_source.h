// An .oni recording as a source: every frame, by the recording's own clock.
#pragma once

#include <explore/openni2/frame_maker.h>
#include <explore/openni2/oni_file.h>

namespace explore::openni2
{
/** When a recorded frame was taken: the first one at recordingStart(), the others as the camera's clock says. */
class RecordedTime
{
public:
	mrpt::Clock::time_point of(const RawDepth& raw);

private:
	std::optional<std::uint64_t> m_first_us;
};

class OniSource : public FrameSource
{
public:
	/** Reads `config.oni`. `logger` outlives it. Throws ConfigError or InputError. */
	OniSource(const SourceConfig& config, mrpt::system::COutputLogger& logger);

	std::optional<DepthFrame> next() override;
	[[nodiscard]] SourceReport report() const override;
	[[nodiscard]] std::optional<double> progress() const override;

private:
	FrameMaker m_maker;
	OniFile m_file;
	RecordedTime m_time;
	std::string m_path;
	std::size_t m_bad = 0;
	std::string m_first_bad;
};
}  // namespace explore::openni2
