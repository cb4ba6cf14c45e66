#include <OpenNI.h>
#include <explore/core/errors.h>
#include <explore/openni2/depth_stream.h>

#include <cmath>
#include <cstring>
#include <utility>

namespace explore::openni2
{
namespace
{
constexpr float kMillimetre_m = 0.001F, kTenthMillimetre_m = 0.0001F;

bool isDepth(openni::PixelFormat format)
{
	return format == openni::PIXEL_FORMAT_DEPTH_1_MM || format == openni::PIXEL_FORMAT_DEPTH_100_UM;
}

std::string sizeText(int width, int height)
{
	return std::to_string(width) + "x" + std::to_string(height);
}

std::string modeText(const openni::VideoMode& mode)
{
	return sizeText(mode.getResolutionX(), mode.getResolutionY()) + " at " + std::to_string(mode.getFps()) + " Hz";
}

std::string listOf(const openni::Array<openni::VideoMode>& modes)
{
	std::string list;
	for (int i = 0; i < modes.getSize(); ++i)
	{
		const std::string text = modeText(modes[i]);
		if (isDepth(modes[i].getPixelFormat()) && list.find(text) == std::string::npos)
			list.append(list.empty() ? "" : ", ").append(text);
	}
	return list;
}

[[noreturn]] void lost(const std::string& what)
{
	throw SensorLost(what + ": " + reasonOfFailure());
}

/** Throws BadFrame unless it holds what its own header says, whole. */
void demandWhole(const openni::VideoFrameRef& frame)
{
	const openni::VideoMode& mode = frame.getVideoMode();
	const int width = frame.getWidth(), height = frame.getHeight(), row_bytes = frame.getStrideInBytes();
	if (!isDepth(mode.getPixelFormat())) throw BadFrame("its pixels are no depth of 1 mm or 0.1 mm");
	if (width < 1 || height < 1 || width != mode.getResolutionX() || height != mode.getResolutionY())
		throw BadFrame("it has " + sizeText(width, height) + " pixels instead of " +
		               sizeText(mode.getResolutionX(), mode.getResolutionY()));
	const std::int64_t needed = static_cast<std::int64_t>(height) * row_bytes;
	if (row_bytes < width * static_cast<int>(sizeof(std::uint16_t)) || frame.getData() == nullptr ||
	    frame.getDataSize() < needed)
		throw BadFrame("it has " + std::to_string(frame.getDataSize()) + " bytes for " + sizeText(width, height) +
		               " pixels");
}

std::vector<std::uint16_t> pixelsOf(const openni::VideoFrameRef& frame)
{
	const auto width = static_cast<std::size_t>(frame.getWidth()), height = static_cast<std::size_t>(frame.getHeight());
	std::vector<std::uint16_t> pixels(width * height);
	const auto* row = static_cast<const char*>(frame.getData());
	for (std::size_t v = 0; v < height; ++v, row += frame.getStrideInBytes())
		std::memcpy(&pixels[v * width], row, width * sizeof(std::uint16_t));
	return pixels;
}
}  // namespace

struct DepthStream::Handles
{
	openni::Device device;
	openni::VideoStream stream;
	int last_number = -1;

	Handles() = default;
	~Handles()
	{
		stream.stop();
		stream.destroy();
		device.close();
	}
	Handles(const Handles&) = delete;
	Handles& operator=(const Handles&) = delete;
};

DepthStream::DepthStream(const std::string& uri, Origin origin, Openni2Config config)
    : m_config(std::move(config)), m_handles(std::make_unique<Handles>())
{
	openDevice(uri);
	if (origin == Origin::camera)
		setUpCamera();
	else
		setUpRecording();
	m_mirrored = m_handles->stream.getMirroringEnabled();
	if (m_handles->stream.start() != openni::STATUS_OK) lost(uri + ": its depth stream does not start");
}

DepthStream::~DepthStream() = default;

void DepthStream::openDevice(const std::string& uri)
{
	openni::Device& device = m_handles->device;
	if (device.open(uri.c_str()) != openni::STATUS_OK) lost(uri + ": cannot be opened");
	if (!device.hasSensor(openni::SENSOR_DEPTH)) throw SensorLost(uri + ": has no depth sensor");
	if (m_handles->stream.create(device, openni::SENSOR_DEPTH) != openni::STATUS_OK)
		lost(uri + ": has no depth stream");
}

void DepthStream::setUpCamera()
{
	setMode();
	setRegistration();
	// Where the camera cannot, its images are turned round here.
	m_handles->stream.setMirroringEnabled(false);
}

void DepthStream::setMode()
{
	const auto& modes = m_handles->stream.getSensorInfo().getSupportedVideoModes();
	const openni::VideoMode* best = nullptr;
	for (int i = 0; i < modes.getSize(); ++i)
	{
		const openni::VideoMode& mode = modes[i];
		const bool fits = isDepth(mode.getPixelFormat()) && mode.getResolutionX() == m_config.width_px &&
		                  mode.getResolutionY() == m_config.height_px && mode.getFps() == m_config.rate_hz;
		// Millimetres reach farther than tenths of them in 16 bits.
		if (fits && (best == nullptr || mode.getPixelFormat() == openni::PIXEL_FORMAT_DEPTH_1_MM)) best = &mode;
	}
	const std::string asked =
	    sizeText(m_config.width_px, m_config.height_px) + " at " + std::to_string(m_config.rate_hz) + " Hz";
	if (best == nullptr)
		throw ConfigError("[openni2] width_px, height_px, rate_hz: the camera has no depth images of " + asked +
		                  "; it has " + listOf(modes));
	if (m_handles->stream.setVideoMode(*best) != openni::STATUS_OK) lost("the camera refuses images of " + asked);
}

void DepthStream::setRegistration()
{
	openni::Device& device = m_handles->device;
	const auto wanted =
	    m_config.registration ? openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR : openni::IMAGE_REGISTRATION_OFF;
	if (m_config.registration && !device.isImageRegistrationModeSupported(wanted))
		throw ConfigError("[openni2] registration = true: the camera cannot do that");
	if (!device.isImageRegistrationModeSupported(wanted)) return;
	if (device.setImageRegistrationMode(wanted) != openni::STATUS_OK && m_config.registration)
		lost("the camera refuses registration");
}

void DepthStream::setUpRecording()
{
	openni::PlaybackControl* playback = m_handles->device.getPlaybackControl();
	if (playback == nullptr) throw SensorLost("is no recording of OpenNI2");
	// Without repeating, closing can crash and nothing tells the end; any other speed loses frames.
	playback->setRepeatEnabled(true);
	playback->setSpeed(-1.0F);
}

CameraIntrinsics DepthStream::intrinsicsFor(int width_px, int height_px) const
{
	const auto focal = [](double given_px, int pixels, float fov_rad)
	{ return given_px > 0.0 ? given_px : pixels / 2.0 / std::tan(static_cast<double>(fov_rad) / 2.0); };
	const auto center = [](double given_px, int pixels) { return given_px > 0.0 ? given_px : (pixels - 1) / 2.0; };
	const openni::VideoStream& stream = m_handles->stream;
	return {width_px,
	        height_px,
	        focal(m_config.fx_px, width_px, stream.getHorizontalFieldOfView()),
	        focal(m_config.fy_px, height_px, stream.getVerticalFieldOfView()),
	        center(m_config.cx_px, width_px),
	        center(m_config.cy_px, height_px)};
}

std::optional<RawDepth> DepthStream::read(std::chrono::milliseconds timeout)
{
	openni::VideoStream* stream = &m_handles->stream;
	int ready = -1;
	const openni::Status waited =
	    openni::OpenNI::waitForAnyStream(&stream, 1, &ready, static_cast<int>(timeout.count()));
	if (waited != openni::STATUS_OK) return std::nullopt;
	openni::VideoFrameRef frame;
	if (stream->readFrame(&frame) != openni::STATUS_OK || !frame.isValid()) return std::nullopt;
	RawDepth raw;
	raw.arrived = mrpt::Clock::now();
	m_handles->last_number = frame.getFrameIndex();
	demandWhole(frame);
	raw.intrinsics = intrinsicsFor(frame.getWidth(), frame.getHeight());
	raw.unit_m =
	    frame.getVideoMode().getPixelFormat() == openni::PIXEL_FORMAT_DEPTH_1_MM ? kMillimetre_m : kTenthMillimetre_m;
	raw.depth = pixelsOf(frame);
	if (m_mirrored) unmirror(raw.depth, raw.intrinsics.width_px);
	raw.device_time_us = frame.getTimestamp();
	return raw;
}

int DepthStream::frameCount() const
{
	openni::PlaybackControl* playback = m_handles->device.getPlaybackControl();
	return playback == nullptr ? 0 : playback->getNumberOfFrames(m_handles->stream);
}

int DepthStream::frameNumber() const
{
	return m_handles->last_number;
}
}  // namespace explore::openni2
