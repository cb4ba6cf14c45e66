// A depth camera that is not there: an OpenNI2 driver that serves the images of a file and does what a control file
// says.
#include "frames_file.h"
#include "live_frame.h"

#include <Driver/OniDriverAPI.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

// What OpenNI's own platform layer has for ONI_EXPORT_DRIVER.
#define XN_NEW(type, ...) new type(__VA_ARGS__)  // NOLINT
#define XN_DELETE(pointer) delete (pointer)      // NOLINT

namespace
{
using explore::test::ServedFrames;
using namespace std::chrono_literals;

constexpr const char* kUri = "virtual/camera@1/1";

/** What the test wants the camera to do now; renewed while it runs. */
struct Control
{
	bool plugged = true, stalled = false, denied = false, starts = true;
	std::string corrupt = "none";  ///< none, size or empty
	std::string unit = "1mm";      ///< 1mm or 100um: the only one that is offered
	double rate_hz = 30;
};

std::string controlFolder()
{
	const char* folder = std::getenv("EXPLORE_VIRTUAL_CAMERA");  // NOLINT(concurrency-mt-unsafe)
	return folder != nullptr ? folder : "";
}

Control readControl()
{
	Control control;
	const std::string folder = controlFolder();
	control.plugged = !folder.empty();
	std::ifstream file(folder + "/control");
	for (std::string line; std::getline(file, line);)
	{
		const std::size_t equals = line.find('=');
		if (equals == std::string::npos) continue;
		const std::string key = line.substr(0, equals), value = line.substr(equals + 1);
		if (key == "plugged") control.plugged = value == "1";
		if (key == "stalled") control.stalled = value == "1";
		if (key == "denied") control.denied = value == "1";
		if (key == "starts") control.starts = value == "1";
		if (key == "corrupt") control.corrupt = value;
		if (key == "unit") control.unit = value;
		if (key == "rate_hz") control.rate_hz = std::stod(value);
	}
	return control;
}

/** The control as it was read last. */
class SharedControl
{
public:
	Control get() const
	{
		const std::lock_guard lock(m_mutex);
		return m_control;
	}
	void renew()
	{
		const Control control = readControl();
		const std::lock_guard lock(m_mutex);
		m_control = control;
	}

private:
	mutable std::mutex m_mutex;
	Control m_control;
};

SharedControl& shared()
{
	static SharedControl control;
	return control;
}

template <class Value>
OniStatus give(const Value& value, void* data, int* size)
{
	if (*size < static_cast<int>(sizeof(Value))) return ONI_STATUS_BAD_PARAMETER;
	std::memcpy(data, &value, sizeof(Value));
	*size = sizeof(Value);
	return ONI_STATUS_OK;
}

OniPixelFormat pixelFormat()
{
	return shared().get().unit == "100um" ? ONI_PIXEL_FORMAT_DEPTH_100_UM : ONI_PIXEL_FORMAT_DEPTH_1_MM;
}

class VirtualStream : public oni::driver::StreamBase
{
public:
	explicit VirtualStream(const ServedFrames& frames)
	    : m_frames(frames), m_mode{pixelFormat(), frames.width_px, frames.height_px, 30}
	{
	}
	~VirtualStream() override { halt(); }
	VirtualStream(const VirtualStream&) = delete;
	VirtualStream& operator=(const VirtualStream&) = delete;

	OniStatus start() override
	{
		if (!shared().get().starts) return ONI_STATUS_ERROR;
		m_runs = true;
		const bool live = std::filesystem::exists(controlFolder() + "/live");
		m_thread = std::thread([this, live] { live ? serveLive() : serve(); });
		return ONI_STATUS_OK;
	}
	void stop() override { halt(); }

	OniBool isPropertySupported(int id) override
	{
		return static_cast<OniBool>(id >= ONI_STREAM_PROPERTY_CROPPING && id <= ONI_STREAM_PROPERTY_MIRRORING);
	}
	OniStatus getProperty(int id, void* data, int* size) override
	{
		const auto fov = [](double pixels, double focal_px)
		{ return static_cast<float>(2.0 * std::atan(pixels / 2.0 / focal_px)); };
		switch (id)
		{
			case ONI_STREAM_PROPERTY_CROPPING:
				return give(OniCropping{0, 0, 0, m_frames.width_px, m_frames.height_px}, data, size);
			case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
				return give(fov(m_frames.width_px, m_frames.fx_px), data, size);
			case ONI_STREAM_PROPERTY_VERTICAL_FOV:
				return give(fov(m_frames.height_px, m_frames.fy_px), data, size);
			case ONI_STREAM_PROPERTY_VIDEO_MODE:
				return give(m_mode, data, size);
			case ONI_STREAM_PROPERTY_MAX_VALUE:
				return give(int{65535}, data, size);
			case ONI_STREAM_PROPERTY_MIN_VALUE:
				return give(int{0}, data, size);
			case ONI_STREAM_PROPERTY_STRIDE:
				return give(static_cast<int>(m_frames.width_px * sizeof(std::uint16_t)), data, size);
			case ONI_STREAM_PROPERTY_MIRRORING:
				return give(OniBool{m_mirrored.load() ? TRUE : FALSE}, data, size);
			default:
				return ONI_STATUS_NOT_SUPPORTED;
		}
	}
	OniStatus setProperty(int id, const void* data, int size) override
	{
		if (id == ONI_STREAM_PROPERTY_MIRRORING && size == sizeof(OniBool))
		{
			OniBool mirrored = FALSE;
			std::memcpy(&mirrored, data, sizeof mirrored);
			m_mirrored = mirrored != FALSE;
			raisePropertyChanged(id, data, size);
			return ONI_STATUS_OK;
		}
		if (id != ONI_STREAM_PROPERTY_VIDEO_MODE || size != sizeof(OniVideoMode)) return ONI_STATUS_NOT_SUPPORTED;
		OniVideoMode mode{};
		std::memcpy(&mode, data, sizeof mode);
		const bool offered = mode.resolutionX == m_frames.width_px && mode.resolutionY == m_frames.height_px &&
		                     mode.pixelFormat == pixelFormat();
		if (!offered) return ONI_STATUS_BAD_PARAMETER;
		m_mode = mode;
		raisePropertyChanged(id, data, size);
		return ONI_STATUS_OK;
	}
	/** The recorder asks all of them once, at its start. */
	void notifyAllProperties() override
	{
		for (int id = ONI_STREAM_PROPERTY_CROPPING; id <= ONI_STREAM_PROPERTY_MIRRORING; ++id)
		{
			char data[sizeof(OniVideoMode) + sizeof(OniCropping)];
			int size = sizeof data;
			if (getProperty(id, data, &size) == ONI_STATUS_OK) raisePropertyChanged(id, data, size);
		}
	}

private:
	void halt()
	{
		m_runs = false;
		if (m_thread.joinable()) m_thread.join();
	}
	/** The rate is that of the stream's start; its clock goes on while it is stalled. */
	void serve()
	{
		m_time_us = 0;
		const double period_s = 1.0 / shared().get().rate_hz;
		const auto period =
		    std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::duration<double>(period_s));
		for (auto due = std::chrono::steady_clock::now() + period; m_runs; due += period)
		{
			while (m_runs && std::chrono::steady_clock::now() < due) std::this_thread::sleep_for(1ms);
			if (!m_runs) break;
			m_time_us += static_cast<std::uint64_t>(period.count());
			const Control control = shared().get();
			const auto& image = m_frames.images[m_number % m_frames.images.size()];
			if (control.plugged && !control.stalled) serveOne(image, control);
		}
	}
	/** Serves what another program leaves, with its times. */
	void serveLive()
	{
		const std::size_t pixels = m_frames.images.front().size();
		for (std::uint64_t last = 0; m_runs; std::this_thread::sleep_for(1ms))
		{
			const auto frame = explore::test::readLiveFrame(controlFolder() + "/live", last, pixels);
			if (!frame) continue;
			last = frame->number;
			m_time_us = frame->time_us;
			serveOne(frame->counts, shared().get());
		}
	}
	void serveOne(const std::vector<std::uint16_t>& image, const Control& control)
	{
		OniFrame* frame = getServices().acquireFrame();
		if (frame == nullptr) return;
		frame->sensorType = ONI_SENSOR_DEPTH;
		frame->videoMode = m_mode;
		frame->width = m_frames.width_px, frame->height = m_frames.height_px;
		frame->croppingEnabled = FALSE, frame->cropOriginX = 0, frame->cropOriginY = 0;
		frame->stride = static_cast<int>(m_frames.width_px * sizeof(std::uint16_t));
		frame->timestamp = m_time_us;
		frame->frameIndex = static_cast<int>(++m_number);
		fill(*frame, image);
		if (control.corrupt == "size") frame->dataSize /= 2, frame->height -= 7;
		if (control.corrupt == "empty") frame->dataSize = 0, frame->width = 0, frame->height = 0;
		raiseNewFrame(frame);
		getServices().releaseFrame(frame);
	}
	void fill(OniFrame& frame, const std::vector<std::uint16_t>& image)
	{
		frame.dataSize = static_cast<int>(image.size() * sizeof(std::uint16_t));
		auto* pixels = static_cast<std::uint16_t*>(frame.data);
		const auto width = static_cast<std::size_t>(m_frames.width_px);
		for (std::size_t i = 0; i < image.size(); ++i)
		{
			const std::size_t column = i % width;
			pixels[i] = image[m_mirrored ? i - column + width - 1 - column : i];
		}
	}

	const ServedFrames& m_frames;
	OniVideoMode m_mode;
	std::atomic<bool> m_mirrored = true;  // as the PrimeSense cameras are when they are opened
	std::atomic<bool> m_runs = false;
	std::uint64_t m_number = 0, m_time_us = 0;
	std::thread m_thread;
};

class VirtualDevice : public oni::driver::DeviceBase
{
public:
	explicit VirtualDevice(ServedFrames frames) : m_frames(std::move(frames))
	{
		m_mode = {pixelFormat(), m_frames.width_px, m_frames.height_px, 30};
		m_sensor = {ONI_SENSOR_DEPTH, 1, &m_mode};
	}
	OniStatus getSensorInfoList(OniSensorInfo** sensors, int* count) override
	{
		*sensors = &m_sensor, *count = 1;
		return ONI_STATUS_OK;
	}
	oni::driver::StreamBase* createStream(OniSensorType type) override
	{
		return type == ONI_SENSOR_DEPTH ? new VirtualStream(m_frames) : nullptr;  // NOLINT: destroyStream() deletes it
	}
	void destroyStream(oni::driver::StreamBase* stream) override { delete stream; }  // NOLINT

	OniBool isPropertySupported(int id) override
	{
		return static_cast<OniBool>(id == ONI_DEVICE_PROPERTY_SERIAL_NUMBER);
	}
	OniStatus getProperty(int id, void* data, int* size) override
	{
		if (id != ONI_DEVICE_PROPERTY_SERIAL_NUMBER) return ONI_STATUS_NOT_SUPPORTED;
		constexpr char kSerial[] = "V0042";
		if (*size < static_cast<int>(sizeof kSerial)) return ONI_STATUS_BAD_PARAMETER;
		std::memcpy(data, kSerial, sizeof kSerial);
		*size = sizeof kSerial;
		return ONI_STATUS_OK;
	}

private:
	ServedFrames m_frames;
	OniVideoMode m_mode{};
	OniSensorInfo m_sensor{};
};

class VirtualDriver : public oni::driver::DriverBase
{
public:
	explicit VirtualDriver(OniDriverServices* services) : DriverBase(services)
	{
		std::strcpy(m_info.uri, kUri);               // NOLINT: fits
		std::strcpy(m_info.vendor, "Nobody");        // NOLINT
		std::strcpy(m_info.name, "Virtual camera");  // NOLINT
	}
	OniStatus initialize(oni::driver::DeviceConnectedCallback connected,
	                     oni::driver::DeviceDisconnectedCallback disconnected,
	                     oni::driver::DeviceStateChangedCallback changed, void* cookie) override
	{
		DriverBase::initialize(connected, disconnected, changed, cookie);
		watch();
		m_runs = true;
		m_watcher = std::thread(
		    [this]
		    {
			    for (; m_runs; std::this_thread::sleep_for(5ms)) watch();
		    });
		return ONI_STATUS_OK;
	}
	oni::driver::DeviceBase* deviceOpen(const char* uri, const char* /*mode*/) override
	{
		const Control control = shared().get();
		if (std::strcmp(uri, kUri) != 0 || !control.plugged) return nullptr;
		if (control.denied)
		{
			getServices().errorLoggerAppend("Failed to open the USB device: access denied");
			return nullptr;
		}
		return new VirtualDevice(explore::test::readServedFrames(controlFolder() + "/frames"));  // NOLINT
	}
	void deviceClose(oni::driver::DeviceBase* device) override { delete device; }  // NOLINT
	void shutdown() override
	{
		m_runs = false;
		if (m_watcher.joinable()) m_watcher.join();
	}

private:
	void watch()
	{
		shared().renew();
		const bool plugged = shared().get().plugged;
		if (plugged && !m_plugged) deviceConnected(&m_info);
		if (!plugged && m_plugged) deviceDisconnected(&m_info);
		m_plugged = plugged;
	}

	OniDeviceInfo m_info{};
	std::atomic<bool> m_runs = false;
	bool m_plugged = false;
	std::thread m_watcher;
};
}  // namespace

ONI_EXPORT_DRIVER(VirtualDriver)
