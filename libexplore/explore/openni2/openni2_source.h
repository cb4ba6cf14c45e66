// A camera as a source: its latest frame each time, and frames without an image while it is away.
#pragma once

#include <explore/openni2/frame_maker.h>
#include <explore/openni2/live_camera.h>

#include <chrono>

namespace explore::openni2
{
/** A frame that was taken longer ago than that when it would be used is dropped: where it was taken, a robot is no
 * more.
 */
inline constexpr std::chrono::milliseconds kOldestUsed{100};

/** The device's clock on this machine's. The frame that came with the least delay since the camera was opened is taken
 *  to have come with none; what is known of it fades by 20 µs a frame, for clocks drift apart. Begins anew where the
 *  two are a second apart, and when each frame of a second has come later than kOldestUsed: the device's clock was set
 *  back then. */
class HostTime
{
public:
	/** When it was taken. */
	mrpt::Clock::time_point taken(const RawDepth& raw);
	/** `time`, or just after the last time that this returned: such times always grow. */
	mrpt::Clock::time_point later(mrpt::Clock::time_point time);
	/** When it was taken, but after the frame before it. */
	mrpt::Clock::time_point of(const RawDepth& raw) { return later(taken(raw)); }

private:
	bool staysLate(mrpt::Clock::duration late, mrpt::Clock::time_point arrived);

	int m_connection = 0;
	mrpt::Clock::duration m_offset{};
	std::optional<mrpt::Clock::time_point> m_late_since;
	mrpt::Clock::time_point m_last;
};

class Openni2Source : public FrameSource
{
public:
	/** `logger` outlives it. Throws ConfigError or SensorLost. */
	Openni2Source(const SourceConfig& config, mrpt::system::COutputLogger& logger);

	/** The latest frame that was not delivered yet, none older than kOldestUsed, or a frame with neither image nor
	 * points when it was unplugged, and after 0.5 s without one: a robot has to stop then. Throws SensorLost. */
	std::optional<DepthFrame> next() override;
	[[nodiscard]] SourceReport report() const override;
	[[nodiscard]] std::optional<double> progress() const override { return std::nullopt; }

private:
	std::optional<DepthFrame> used(const RawDepth& raw);
	void passOnMessages();

	mrpt::system::COutputLogger& m_logger;
	FrameMaker m_maker;
	LiveCamera m_camera;
	HostTime m_time;
	std::optional<double> m_oldest_ms;
	std::size_t m_too_old = 0;
	std::string m_device;
};
}  // namespace explore::openni2
