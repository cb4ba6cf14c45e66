// A depth camera that is not there: an OpenNI2 driver that serves the images of a file and does what a control file
// says.
#include "control.h"
#include "frames_file.h"
#include "virtual_stream.h"

#include <Driver/OniDriverAPI.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

// What OpenNI's own platform layer has for ONI_EXPORT_DRIVER.
#define XN_NEW(type, ...) new type(__VA_ARGS__)  // NOLINT
#define XN_DELETE(pointer) delete (pointer)      // NOLINT

namespace
{
using namespace explore::test;
using namespace std::chrono_literals;

constexpr const char* kUri = "virtual/camera@1/1";

class VirtualDevice : public oni::driver::DeviceBase
{
public:
	explicit VirtualDevice(ServedFrames frames) : m_frames(std::move(frames))
	{
		for (const OniSensorType sensor : {ONI_SENSOR_DEPTH, ONI_SENSOR_COLOR})
		{
			if (sensor == ONI_SENSOR_COLOR && shared().get().color == "none") continue;
			OniVideoMode& mode = m_modes.at(m_sensors.size());
			mode = {pixelFormat(sensor), m_frames.width_px, m_frames.height_px, 30};
			m_sensors.push_back({sensor, 1, &mode});
		}
	}
	OniStatus getSensorInfoList(OniSensorInfo** sensors, int* count) override
	{
		*sensors = m_sensors.data(), *count = static_cast<int>(m_sensors.size());
		return ONI_STATUS_OK;
	}
	oni::driver::StreamBase* createStream(OniSensorType type) override
	{
		for (const OniSensorInfo& sensor : m_sensors)
			if (sensor.sensorType == type)
				return new VirtualStream(type, m_frames, m_clock);  // NOLINT: destroyStream() deletes it
		return nullptr;
	}
	void destroyStream(oni::driver::StreamBase* stream) override { delete stream; }  // NOLINT

	OniBool isPropertySupported(int id) override
	{
		return static_cast<OniBool>(id == ONI_DEVICE_PROPERTY_SERIAL_NUMBER ||
		                            id == ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION);
	}
	OniBool isImageRegistrationModeSupported(OniImageRegistrationMode mode) override
	{
		return static_cast<OniBool>(mode == ONI_IMAGE_REGISTRATION_OFF || shared().get().registers);
	}
	/** Leaves what was set in a file, for the test. */
	OniStatus setProperty(int id, const void* data, int size) override
	{
		if (id != ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION || size != sizeof m_registration)
			return ONI_STATUS_NOT_SUPPORTED;
		std::memcpy(&m_registration, data, sizeof m_registration);
		std::ofstream(controlFolder() + "/registration") << m_registration;
		return ONI_STATUS_OK;
	}
	OniStatus getProperty(int id, void* data, int* size) override
	{
		if (id == ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION) return give(m_registration, data, size);
		if (id != ONI_DEVICE_PROPERTY_SERIAL_NUMBER) return ONI_STATUS_NOT_SUPPORTED;
		constexpr char kSerial[] = "V0042";
		if (*size < static_cast<int>(sizeof kSerial)) return ONI_STATUS_BAD_PARAMETER;
		std::memcpy(data, kSerial, sizeof kSerial);
		*size = sizeof kSerial;
		return ONI_STATUS_OK;
	}

private:
	ServedFrames m_frames;
	Clock m_clock;
	std::array<OniVideoMode, 2> m_modes{};
	std::vector<OniSensorInfo> m_sensors;
	OniImageRegistrationMode m_registration = ONI_IMAGE_REGISTRATION_OFF;
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
		return new VirtualDevice(readServedFrames(controlFolder() + "/frames"));  // NOLINT
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
