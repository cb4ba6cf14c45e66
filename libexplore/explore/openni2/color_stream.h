// The colour stream beside a depth stream: the latest image, for the depth image that it belongs to.
#pragma once

#include <OpenNI.h>
#include <explore/openni2/raw_depth.h>
#include <explore/sources/source_config.h>

#include <cstdint>
#include <optional>

namespace explore::openni2
{
class ColorStream
{
public:
	/** Opens it. Of a camera its images are 8-bit RGB and have size and rate of the depth images, where the camera has
	 * such a mode, else those that come nearest. Throws ConfigError for a camera or recording without such images. */
	ColorStream(openni::Device& device, bool is_recording, const Openni2Config& config);
	~ColorStream();
	ColorStream(const ColorStream&) = delete;
	ColorStream& operator=(const ColorStream&) = delete;

	/** Throws ConfigError, with OpenNI2's reason, for one that does not start. */
	void start();
	[[nodiscard]] openni::VideoStream& stream() { return m_stream; }
	/** Takes the image that has come instead of the one before. */
	void take();
	/** The latest image, if it was taken within one and a half of its periods of that time by the camera's clock, and
	 * is whole. */
	[[nodiscard]] std::optional<ColorImage> imageAt(std::uint64_t device_time_us) const;

private:
	void setMode(const Openni2Config& config);

	openni::VideoStream m_stream;
	openni::VideoFrameRef m_latest;
	bool m_mirrored = false;
	FieldOfView m_view;
	double m_period_us = 0;
};
}  // namespace explore::openni2
