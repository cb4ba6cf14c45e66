#include "openni2/virtual_camera.h"

#include "support/analytic_scene.h"
#include "support/test_files.h"

#include <OpenNI.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <thread>

// OpenNI2's drivers leave memory behind when they are unloaded, and leaks of unloaded modules cannot be told apart by
// name.
extern "C" const char* __asan_default_options()  // NOLINT: AddressSanitizer's name
{
	return "detect_leaks=0";
}

// Also where CTest asks the program for its tests. The programs that tests run get it from the environment.
extern "C" const char* __tsan_default_options()  // NOLINT: ThreadSanitizer's name
{
	return "suppressions=" EXPLORE_SOURCE_DIR "/tests/support/tsan.supp";
}

namespace explore::test
{
VirtualCamera::VirtualCamera(int width_px, int height_px, int frames, double unit_m)
    : m_folder(freshFolder() / "camera"), m_unit_m(unit_m), m_control{{"plugged", "1"}}
{
	const Scene scene = corridorScene(8.0, {2.0}, {4.0});
	const CameraIntrinsics camera = xtionIntrinsics(width_px, height_px);
	m_served = {width_px, height_px, camera.fx_px, camera.fy_px, {}};
	for (int i = 0; i < frames; ++i)
	{
		const mrpt::poses::CPose3D map_from_robot(0.02 * i, 0.1, 0, 0.05, 0, 0);
		const DepthFrame frame = renderFrame(scene, map_from_robot, {0, 0, 0.5, 0, 0, 0}, camera);
		std::vector<std::uint16_t> counts;
		for (const float depth_m : frame.image.depth_m)
			counts.push_back(static_cast<std::uint16_t>(std::min(65535.0, std::round(depth_m / unit_m))));
		m_served.images.push_back(std::move(counts));
	}
	std::filesystem::create_directories(m_folder);
	writeServedFrames(m_folder / "frames", m_served);
	write();
	::setenv("EXPLORE_VIRTUAL_CAMERA", m_folder.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread so far
}

VirtualCamera::~VirtualCamera()
{
	::unsetenv("EXPLORE_VIRTUAL_CAMERA");  // NOLINT(concurrency-mt-unsafe): the camera's threads have ended
}

void VirtualCamera::set(const std::string& key, const std::string& value)
{
	m_control[key] = value;
	write();
	std::this_thread::sleep_for(std::chrono::milliseconds(30));
}

void VirtualCamera::write() const
{
	std::string text;
	for (const auto& [key, value] : m_control) text.append(key).append("=").append(value).append("\n");
	writeFile(m_folder / "control.new", text);
	std::filesystem::rename(m_folder / "control.new", m_folder / "control");
}

int VirtualCamera::imageOf(const DepthImage& depth) const
{
	for (std::size_t i = 0; i < m_served.images.size(); ++i)
	{
		const auto& counts = m_served.images[i];
		bool same = counts.size() == depth.depth_m.size();
		for (std::size_t k = 0; same && k < counts.size(); ++k)
			same = std::abs(depth.depth_m[k] - counts[k] * m_unit_m) < 1e-5;
		if (same) return static_cast<int>(i);
	}
	return -1;
}

std::string VirtualCamera::left(const std::string& name) const
{
	return readFile(m_folder / name);
}

SourceConfig VirtualCamera::config() const
{
	SourceConfig config;
	config.kind = SourceKind::openni2;
	config.openni2.width_px = m_served.width_px;
	config.openni2.height_px = m_served.height_px;
	config.openni2.lost_after_s = 4;
	config.camera.mount = MountPolicy::ini;
	return config;
}

void recordOni(const std::filesystem::path& path, int frames, const OniOptions& options)
{
	const auto demand = [](openni::Status status, const char* what)
	{
		if (status != openni::STATUS_OK)
			throw std::runtime_error(what + std::string(openni::OpenNI::getExtendedError()));
	};
	demand(openni::OpenNI::initialize(), "initialize: ");
	{
		openni::Device device;
		demand(device.open(openni::ANY_DEVICE), "open: ");
		openni::VideoStream stream;
		demand(stream.create(device, openni::SENSOR_DEPTH), "create: ");
		demand(stream.setMirroringEnabled(options.mirrored), "mirror: ");
		openni::Recorder recorder;
		demand(recorder.create(path.c_str()), "recorder: ");
		demand(recorder.attach(stream, true), "attach: ");
		openni::VideoStream color;
		if (options.color)
		{
			demand(color.create(device, openni::SENSOR_COLOR), "create colour: ");
			demand(color.setMirroringEnabled(options.mirrored), "mirror colour: ");
			demand(recorder.attach(color, true), "attach colour: ");
			demand(color.start(), "start colour: ");
		}
		demand(stream.start(), "start: ");
		demand(recorder.start(), "record: ");
		openni::VideoFrameRef frame;
		for (int i = 0; i < frames + 5; ++i) demand(stream.readFrame(&frame), "read: ");
		frame.release();
		// Streams first: a recorder that is stopped while frames of two streams come may wait for ever.
		color.stop();
		stream.stop();
		recorder.stop();
		recorder.destroy();
		color.destroy();
		stream.destroy();
		device.close();
	}
	openni::OpenNI::shutdown();
}
}  // namespace explore::test
