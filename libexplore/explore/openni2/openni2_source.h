// A camera as a source: its latest frame each time, and frames without an image while it is away.
#pragma once

#include <explore/openni2/frame_maker.h>
#include <explore/openni2/live_camera.h>

namespace explore::openni2
{
/** The device's clock on this machine's. The frame that came with the least delay since the camera was opened is taken
 *  to have come with none; what is known of it fades by 20 µs a frame, for clocks drift apart. Begins anew where the
 * two are a second apart. Times always grow. */
class HostTime
{
public:
	mrpt::Clock::time_point of(const RawDepth& raw);
	/** Of something that is no frame. */
	mrpt::Clock::time_point later(mrpt::Clock::time_point time);

private:
	int m_connection = 0;
	mrpt::Clock::duration m_offset{};
	mrpt::Clock::time_point m_last;
};

class Openni2Source : public FrameSource
{
public:
	/** `logger` outlives it. Throws ConfigError or SensorLost. */
	Openni2Source(const SourceConfig& config, mrpt::system::COutputLogger& logger);

	/** The latest frame that was not delivered yet, or a frame with neither image nor points when it was unplugged, and
	 * after 0.5 s without one: a robot has to stop then. Throws SensorLost. */
	std::optional<DepthFrame> next() override;
	[[nodiscard]] SourceReport report() const override;
	[[nodiscard]] std::optional<double> progress() const override { return std::nullopt; }

private:
	void passOnMessages();

	mrpt::system::COutputLogger& m_logger;
	FrameMaker m_maker;
	LiveCamera m_camera;
	HostTime m_time;
	std::optional<double> m_oldest_ms;
	std::string m_device;
};
}  // namespace explore::openni2
