// The virtual camera as tests use it: what it sees, and its cable.
#pragma once

#include "support/virtual_camera/frames_file.h"

#include <explore/core/depth_frame.h>
#include <explore/sources/source_config.h>

#include <filesystem>
#include <map>
#include <string>

namespace explore::test
{
/** A camera that moves along a corridor; plugged in from the start to the end of this object. */
class VirtualCamera
{
public:
	/** `frames` images of a corridor with doors, the camera 2 cm further in each; counts of `unit_m`. */
	explicit VirtualCamera(int width_px = 160, int height_px = 120, int frames = 30, double unit_m = 0.001);
	~VirtualCamera();
	VirtualCamera(const VirtualCamera&) = delete;
	VirtualCamera& operator=(const VirtualCamera&) = delete;

	/** Sets one line of its control file: plugged, stalled, denied, starts, registers (0 or 1), corrupt (none, size,
	 *  empty), unit (1mm, 100um), color (rgb, none, yuv, refused, stalled), rate_hz, late_s. Waits until the driver has
	 *  surely read it. */
	void set(const std::string& key, const std::string& value);

	[[nodiscard]] const ServedFrames& served() const { return m_served; }
	/** The number of the image that is all of `depth`; -1 = none of them. */
	[[nodiscard]] int imageOf(const DepthImage& depth) const;
	/** What the driver left behind under this name: served, how many depth frames the stream that was stopped last had
	 *  delivered; registration, the mode that was set last. */
	[[nodiscard]] std::string left(const std::string& name) const;
	/** [source] and [openni2] that suit it. */
	[[nodiscard]] SourceConfig config() const;

private:
	void write() const;

	std::filesystem::path m_folder;
	ServedFrames m_served;
	double m_unit_m;
	std::map<std::string, std::string> m_control;
};

struct OniOptions
{
	bool mirrored = false;
	bool color = false;
};
/** Records at least `frames` frames of the virtual camera with OpenNI2's own recorder. */
void recordOni(const std::filesystem::path& path, int frames, const OniOptions& options = {});
}  // namespace explore::test
