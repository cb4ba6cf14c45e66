// Blanks the pixels in which the camera sees its own robot.
#pragma once

#include <explore/core/depth_frame.h>

#include <string>
#include <vector>

namespace explore
{
class SelfMask
{
public:
	/** Reads an image whose non-black pixels see the robot; none for an empty path. Throws ConfigError for a file that
	 *  is missing or no image. */
	explicit SelfMask(const std::string& path);

	/** Sets the masked pixels of a row-major width × height image to 0 (no return). Throws ConfigError when the mask
	 * has another size. */
	void apply(int width_px, int height_px, std::vector<float>& values) const;

private:
	std::string m_path;
	int m_width_px = 0, m_height_px = 0;
	std::vector<bool> m_robot;
};
}  // namespace explore
