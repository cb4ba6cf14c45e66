// One stream of the virtual camera, depth or colour: a thread that serves images at their times.
#pragma once

#include <Driver/OniDriverAPI.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "control.h"
#include "frames_file.h"
#include "live_frame.h"

namespace explore::test
{
using namespace std::chrono_literals;

template <class Value>
OniStatus give(const Value& value, void* data, int* size)
{
	if (*size < static_cast<int>(sizeof(Value))) return ONI_STATUS_BAD_PARAMETER;
	std::memcpy(data, &value, sizeof(Value));
	*size = sizeof(Value);
	return ONI_STATUS_OK;
}

/** What both streams of a device go by: image n is taken n periods after it was opened. */
struct Clock
{
	std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
	std::chrono::microseconds period = std::chrono::duration_cast<std::chrono::microseconds>(
	    std::chrono::duration<double>(1.0 / readControl().rate_hz));
	/** The next image to be taken. */
	[[nodiscard]] std::uint64_t next() const
	{
		return static_cast<std::uint64_t>((std::chrono::steady_clock::now() - start) / period) + 1;
	}
};

inline OniPixelFormat pixelFormat(OniSensorType sensor)
{
	if (sensor == ONI_SENSOR_COLOR)
		return shared().get().color == "yuv" ? ONI_PIXEL_FORMAT_YUV422 : ONI_PIXEL_FORMAT_RGB888;
	return shared().get().unit == "100um" ? ONI_PIXEL_FORMAT_DEPTH_100_UM : ONI_PIXEL_FORMAT_DEPTH_1_MM;
}

class VirtualStream : public oni::driver::StreamBase
{
public:
	VirtualStream(OniSensorType sensor, const ServedFrames& frames, const Clock& clock)
	    : m_sensor(sensor),
	      m_frames(frames),
	      m_clock(clock),
	      m_mode{pixelFormat(sensor), frames.width_px, frames.height_px, 30}
	{
	}
	~VirtualStream() override { halt(); }
	VirtualStream(const VirtualStream&) = delete;
	VirtualStream& operator=(const VirtualStream&) = delete;

	OniStatus start() override
	{
		const Control control = shared().get();
		if (!control.starts || (isColor() && control.color == "refused")) return ONI_STATUS_ERROR;
		m_runs = true;
		const bool live = std::filesystem::exists(controlFolder() + "/live");
		if (live && isColor()) return ONI_STATUS_ERROR;
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
				return give(m_frames.width_px * pixelBytes(), data, size);
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
		                     mode.pixelFormat == pixelFormat(m_sensor);
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
	[[nodiscard]] bool isColor() const { return m_sensor == ONI_SENSOR_COLOR; }
	[[nodiscard]] int pixelBytes() const { return isColor() ? 3 : 2; }
	void halt()
	{
		m_runs = false;
		if (m_thread.joinable()) m_thread.join();
		const std::string folder = controlFolder();
		if (!isColor() && !folder.empty()) std::ofstream(folder + "/served") << m_served << '\n';
	}
	/** The rate is that of the device's opening; its clock goes on while it is stalled. */
	void serve()
	{
		for (std::uint64_t number = m_clock.next(); m_runs; ++number)
		{
			const auto taken = m_clock.start + number * m_clock.period;
			while (m_runs && std::chrono::steady_clock::now() < taken + lateness()) std::this_thread::sleep_for(1ms);
			if (!m_runs) break;
			m_time_us = number * static_cast<std::uint64_t>(m_clock.period.count());
			const Control control = shared().get();
			if (control.plugged && !control.stalled && !(isColor() && control.color == "stalled"))
				serveOne(number % m_frames.images.size(), control);
		}
	}
	[[nodiscard]] static std::chrono::microseconds lateness()
	{
		return std::chrono::duration_cast<std::chrono::microseconds>(
		    std::chrono::duration<double>(shared().get().late_s));
	}
	/** Serves what another program leaves, with its times. */
	void serveLive()
	{
		const std::size_t pixels = m_frames.images.front().size();
		for (std::uint64_t last = 0; m_runs; std::this_thread::sleep_for(1ms))
		{
			const auto frame = readLiveFrame(controlFolder() + "/live", last, pixels);
			if (!frame) continue;
			last = frame->number;
			m_time_us = frame->time_us;
			serveOne(shared().get(), [&](OniFrame& served) { fillDepth(served, frame->counts); });
		}
	}
	void serveOne(std::size_t image, const Control& control)
	{
		serveOne(control,
		         [&](OniFrame& frame)
		         {
			         if (isColor())
				         fillColor(frame, image);
			         else
				         fillDepth(frame, m_frames.images[image]);
		         });
	}
	template <class Fill>
	void serveOne(const Control& control, const Fill& fill)
	{
		OniFrame* frame = getServices().acquireFrame();
		if (frame == nullptr) return;
		frame->sensorType = m_sensor;
		frame->videoMode = m_mode;
		frame->width = m_frames.width_px, frame->height = m_frames.height_px;
		frame->croppingEnabled = FALSE, frame->cropOriginX = 0, frame->cropOriginY = 0;
		frame->stride = m_frames.width_px * pixelBytes();
		frame->dataSize = frame->stride * frame->height;
		frame->timestamp = m_time_us;
		frame->frameIndex = static_cast<int>(++m_served);
		fill(*frame);
		if (control.corrupt == "size") frame->dataSize /= 2, frame->height -= 7;
		if (control.corrupt == "empty") frame->dataSize = 0, frame->width = 0, frame->height = 0;
		raiseNewFrame(frame);
		getServices().releaseFrame(frame);
	}
	/** Of a frame, which may be mirrored. */
	[[nodiscard]] std::size_t seenAt(std::size_t pixel) const
	{
		const auto width = static_cast<std::size_t>(m_frames.width_px);
		const std::size_t column = pixel % width;
		return m_mirrored ? pixel - column + width - 1 - column : pixel;
	}
	void fillDepth(OniFrame& frame, const std::vector<std::uint16_t>& image) const
	{
		auto* pixels = static_cast<std::uint16_t*>(frame.data);
		for (std::size_t i = 0; i < image.size(); ++i) pixels[i] = image[seenAt(i)];
	}
	void fillColor(OniFrame& frame, std::size_t image) const
	{
		auto* pixels = static_cast<std::array<std::uint8_t, 3>*>(frame.data);
		const auto width = static_cast<std::size_t>(m_frames.width_px);
		for (std::size_t i = 0; i < m_frames.images.front().size(); ++i)
			pixels[i] =
			    servedColor(image, m_frames.images.size(), static_cast<int>(seenAt(i) % width), m_frames.width_px);
	}

	OniSensorType m_sensor;
	const ServedFrames& m_frames;
	const Clock& m_clock;
	OniVideoMode m_mode;
	std::atomic<bool> m_mirrored = true;  // as the PrimeSense cameras are when they are opened
	std::atomic<bool> m_runs = false;
	std::uint64_t m_served = 0, m_time_us = 0;
	std::thread m_thread;
};
}  // namespace explore::test
