#include <explore/openni2/stream_frame.h>

#include <cmath>
#include <cstdint>

namespace explore::openni2
{
std::string sizeText(int width_px, int height_px)
{
	return std::to_string(width_px) + "x" + std::to_string(height_px);
}

std::string listOf(const openni::Array<openni::VideoMode>& modes, PixelTest test)
{
	std::string list;
	for (int i = 0; i < modes.getSize(); ++i)
	{
		const openni::VideoMode& mode = modes[i];
		const std::string text =
		    sizeText(mode.getResolutionX(), mode.getResolutionY()) + " at " + std::to_string(mode.getFps()) + " Hz";
		if (test(mode.getPixelFormat()) && list.find(text) == std::string::npos)
			list.append(list.empty() ? "" : ", ").append(text);
	}
	return list;
}

CameraIntrinsics intrinsicsOf(const FieldOfView& view, int width_px, int height_px)
{
	const auto focal = [](int pixels, double angle_rad) { return pixels / 2.0 / std::tan(angle_rad / 2.0); };
	return {width_px,
	        height_px,
	        focal(width_px, view.horizontal_rad),
	        focal(height_px, view.vertical_rad),
	        (width_px - 1) / 2.0,
	        (height_px - 1) / 2.0};
}

FieldOfView fieldOfView(const openni::VideoStream& stream)
{
	return {static_cast<double>(stream.getHorizontalFieldOfView()),
	        static_cast<double>(stream.getVerticalFieldOfView())};
}

void demandWhole(const openni::VideoFrameRef& frame, int bytes_per_pixel)
{
	const openni::VideoMode& mode = frame.getVideoMode();
	const int width = frame.getWidth(), height = frame.getHeight(), row_bytes = frame.getStrideInBytes();
	if (width < 1 || height < 1 || width != mode.getResolutionX() || height != mode.getResolutionY())
		throw BadFrame("it has " + sizeText(width, height) + " pixels instead of " +
		               sizeText(mode.getResolutionX(), mode.getResolutionY()));
	const std::int64_t needed = static_cast<std::int64_t>(height) * row_bytes;
	if (row_bytes < width * bytes_per_pixel || frame.getData() == nullptr || frame.getDataSize() < needed)
		throw BadFrame("it has " + std::to_string(frame.getDataSize()) + " bytes for " + sizeText(width, height) +
		               " pixels");
}
}  // namespace explore::openni2
