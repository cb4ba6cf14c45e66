#include <explore/core/errors.h>
#include <explore/openni2/color_stream.h>
#include <explore/openni2/library.h>
#include <explore/openni2/stream_frame.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <tuple>

namespace explore::openni2
{
namespace
{
constexpr double kOldestPeriods = 1.5;

bool isRgb(openni::PixelFormat format)
{
	return format == openni::PIXEL_FORMAT_RGB888;
}

[[noreturn]] void refuse(const std::string& why)
{
	throw ConfigError("[openni2] color = true: " + why);
}

/** How far a mode is from the one that is wanted: in pixels, then in rate. */
std::tuple<int, int, int> differenceOf(const openni::VideoMode& mode, const Openni2Config& config)
{
	return {std::abs(mode.getResolutionX() - config.width_px), std::abs(mode.getResolutionY() - config.height_px),
	        std::abs(mode.getFps() - config.rate_hz)};
}
}  // namespace

ColorStream::ColorStream(openni::Device& device, bool is_recording, const Openni2Config& config)
{
	const std::string it = is_recording ? "the recording" : "the camera";
	if (!device.hasSensor(openni::SENSOR_COLOR)) refuse(it + " has no colour images");
	if (m_stream.create(device, openni::SENSOR_COLOR) != openni::STATUS_OK)
		refuse(it + " has no colour stream: " + reasonOfFailure());
	if (!is_recording)
	{
		setMode(config);
		m_stream.setMirroringEnabled(false);
	}
	else if (!isRgb(m_stream.getVideoMode().getPixelFormat()))
		refuse("the recording's colour images are not 8-bit RGB");
	m_mirrored = m_stream.getMirroringEnabled();
	m_view = fieldOfView(m_stream);
	m_period_us = 1e6 / std::max(1, m_stream.getVideoMode().getFps());
}

ColorStream::~ColorStream()
{
	m_latest.release();
	m_stream.stop();
	m_stream.destroy();
}

void ColorStream::setMode(const Openni2Config& config)
{
	const auto& modes = m_stream.getSensorInfo().getSupportedVideoModes();
	const openni::VideoMode* best = nullptr;
	for (int i = 0; i < modes.getSize(); ++i)
		if (isRgb(modes[i].getPixelFormat()) &&
		    (best == nullptr || differenceOf(modes[i], config) < differenceOf(*best, config)))
			best = &modes[i];
	if (best == nullptr) refuse("the camera has no colour images of 8-bit RGB");
	if (m_stream.setVideoMode(*best) != openni::STATUS_OK)
		refuse("the camera refuses colour images of " + sizeText(best->getResolutionX(), best->getResolutionY()) +
		       "; it has " + listOf(modes, isRgb) + ": " + reasonOfFailure());
}

void ColorStream::start()
{
	if (m_stream.start() != openni::STATUS_OK) refuse("the colour stream does not start: " + reasonOfFailure());
}

void ColorStream::take()
{
	if (m_stream.readFrame(&m_latest) != openni::STATUS_OK) m_latest.release();
}

std::optional<ColorImage> ColorStream::imageAt(std::uint64_t device_time_us) const
{
	if (!m_latest.isValid()) return std::nullopt;
	const auto apart_us = static_cast<std::int64_t>(m_latest.getTimestamp() - device_time_us);
	if (std::abs(static_cast<double>(apart_us)) > kOldestPeriods * m_period_us) return std::nullopt;
	try
	{
		demandWhole(m_latest, sizeof(Rgb));
	}
	catch (const BadFrame&)
	{
		return std::nullopt;
	}
	ColorImage image{intrinsicsOf(m_view, m_latest.getWidth(), m_latest.getHeight()), pixelsOf<Rgb>(m_latest)};
	if (m_mirrored) unmirror(image.pixels, image.intrinsics.width_px);
	return image;
}
}  // namespace explore::openni2
