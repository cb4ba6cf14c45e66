#include <OpenNI.h>
#include <explore/core/errors.h>
#include <explore/openni2/color_stream.h>
#include <explore/openni2/depth_stream.h>
#include <explore/openni2/stream_frame.h>

#include <algorithm>
#include <array>
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

[[noreturn]] void lost(const std::string& what)
{
	throw SensorLost(what + ": " + reasonOfFailure());
}

}  // namespace

struct DepthStream::Handles
{
	openni::Device device;
	openni::VideoStream stream;
	std::unique_ptr<ColorStream> color;
	int last_number = -1;

	Handles() = default;
	~Handles()
	{
		color.reset();
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
	m_view = fieldOfView(m_handles->stream);
	if (m_config.color)
		m_handles->color = std::make_unique<ColorStream>(m_handles->device, origin == Origin::recording, m_config);
	start(uri);
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

void DepthStream::start(const std::string& uri)
{
	if (m_handles->color) m_handles->color->start();
	if (m_handles->stream.start() != openni::STATUS_OK) lost(uri + ": its depth stream does not start");
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
		                  "; it has " + listOf(modes, isDepth));
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
	CameraIntrinsics intrinsics = intrinsicsOf(m_view, width_px, height_px);
	const auto replace = [](double& told_px, double given_px)
	{
		if (given_px > 0.0) told_px = given_px;
	};
	replace(intrinsics.fx_px, m_config.fx_px);
	replace(intrinsics.fy_px, m_config.fy_px);
	replace(intrinsics.cx_px, m_config.cx_px);
	replace(intrinsics.cy_px, m_config.cy_px);
	return intrinsics;
}

bool DepthStream::awaitDepth(std::chrono::milliseconds timeout)
{
	using std::chrono::steady_clock;
	const auto due = steady_clock::now() + timeout;
	openni::VideoStream* const depth = &m_handles->stream;
	ColorStream* const color = m_handles->color.get();
	// The one that was taken first is told first; of two that were taken at once the first one here.
	std::array<openni::VideoStream*, 2> streams{color != nullptr ? &color->stream() : depth, depth};
	while (true)
	{
		const auto rest = std::chrono::ceil<std::chrono::milliseconds>(due - steady_clock::now());
		const int rest_ms = static_cast<int>(std::max<std::int64_t>(0, rest.count()));
		int ready = -1;
		const openni::Status waited =
		    openni::OpenNI::waitForAnyStream(streams.data(), color != nullptr ? 2 : 1, &ready, rest_ms);
		if (waited != openni::STATUS_OK) return false;
		if (streams.at(static_cast<std::size_t>(ready)) == depth) return true;
		color->take();
	}
}

std::optional<RawDepth> DepthStream::read(std::chrono::milliseconds timeout)
{
	if (!awaitDepth(timeout)) return std::nullopt;
	openni::VideoFrameRef frame;
	if (m_handles->stream.readFrame(&frame) != openni::STATUS_OK || !frame.isValid()) return std::nullopt;
	RawDepth raw;
	raw.arrived = mrpt::Clock::now();
	m_handles->last_number = frame.getFrameIndex();
	const openni::PixelFormat format = frame.getVideoMode().getPixelFormat();
	if (!isDepth(format)) throw BadFrame("its pixels are no depth of 1 mm or 0.1 mm");
	demandWhole(frame, sizeof(std::uint16_t));
	raw.intrinsics = intrinsicsFor(frame.getWidth(), frame.getHeight());
	raw.unit_m = format == openni::PIXEL_FORMAT_DEPTH_1_MM ? kMillimetre_m : kTenthMillimetre_m;
	raw.depth = pixelsOf<std::uint16_t>(frame);
	if (m_mirrored) unmirror(raw.depth, raw.intrinsics.width_px);
	raw.device_time_us = frame.getTimestamp();
	if (m_handles->color) raw.color = colorFor(raw);
	return raw;
}

std::optional<ColorImage> DepthStream::colorFor(const RawDepth& raw) const
{
	auto color = m_handles->color->imageAt(raw.device_time_us);
	const auto size_of = [](const CameraIntrinsics& camera) { return std::pair(camera.width_px, camera.height_px); };
	// Registered depth is what the colour camera would measure: through the same lens.
	if (color && m_config.registration && size_of(color->intrinsics) == size_of(raw.intrinsics))
		color->intrinsics = raw.intrinsics;
	return color;
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
