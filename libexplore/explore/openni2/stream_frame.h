// What the depth and the colour stream of a camera have in common: their modes, their frames, the pinhole behind them.
#pragma once

#include <OpenNI.h>
#include <explore/openni2/raw_depth.h>
#include <explore/sources/source_config.h>

#include <cstring>
#include <string>
#include <vector>

namespace explore::openni2
{
/** "640x480". */
std::string sizeText(int width_px, int height_px);

using PixelTest = bool (*)(openni::PixelFormat);
/** The modes whose pixels pass the test, "640x480 at 30 Hz, 320x240 at 60 Hz", each once; "" for none. */
std::string listOf(const openni::Array<openni::VideoMode>& modes, PixelTest test);

/** From a stream's field of view; the principal point is the middle of the image. */
CameraIntrinsics intrinsicsOf(const FieldOfView& view, int width_px, int height_px);

/** Asked before the stream starts: a recording's player renews what it tells while it plays, and locks nothing. */
FieldOfView fieldOfView(const openni::VideoStream& stream);

/** Throws BadFrame unless the frame holds what its own header says, whole. */
void demandWhole(const openni::VideoFrameRef& frame, int bytes_per_pixel);

/** Row-major; of a frame that is whole. */
template <class Pixel>
std::vector<Pixel> pixelsOf(const openni::VideoFrameRef& frame)
{
	const auto width = static_cast<std::size_t>(frame.getWidth()), height = static_cast<std::size_t>(frame.getHeight());
	std::vector<Pixel> pixels(width * height);
	const auto* row = static_cast<const char*>(frame.getData());
	for (std::size_t v = 0; v < height; ++v, row += frame.getStrideInBytes())
		std::memcpy(&pixels[v * width], row, width * sizeof(Pixel));
	return pixels;
}
}  // namespace explore::openni2
