// The images that the virtual camera serves, as a test leaves them for its driver.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace explore::test
{
/** Row-major depth images of one size, in the unit of the camera; 0 = no return. They are served over and over. */
struct ServedFrames
{
	int width_px = 0, height_px = 0;
	double fx_px = 0, fy_px = 0;
	std::vector<std::vector<std::uint16_t>> images;
};

/** What the colour camera shows of depth image `image` in this column of `columns`: another colour on the left than on
 *  the right, and a blue that tells the image. */
inline std::array<std::uint8_t, 3> servedColor(std::size_t image, std::size_t images, int column, int columns)
{
	const auto blue = static_cast<std::uint8_t>(10 + 236 * (image % images) / images);
	if (2 * column < columns) return {220, 40, blue};
	return {40, 220, blue};
}
/** The image that this blue tells, but for what compression does to it. */
inline double imageOfBlue(double blue, std::size_t images)
{
	return (blue - 10.0) * static_cast<double>(images) / 236.0;
}

inline void writeServedFrames(const std::filesystem::path& path, const ServedFrames& frames)
{
	std::ofstream file(path, std::ios::binary);
	file << frames.width_px << ' ' << frames.height_px << ' ' << frames.fx_px << ' ' << frames.fy_px << ' '
	     << frames.images.size() << '\n';
	for (const auto& image : frames.images)
		file.write(reinterpret_cast<const char*>(image.data()),  // NOLINT: bytes
		           static_cast<std::streamsize>(image.size() * sizeof(std::uint16_t)));
}

inline ServedFrames readServedFrames(const std::filesystem::path& path)
{
	ServedFrames frames;
	std::size_t count = 0;
	std::ifstream file(path, std::ios::binary);
	file >> frames.width_px >> frames.height_px >> frames.fx_px >> frames.fy_px >> count;
	file.get();
	const auto pixels = static_cast<std::size_t>(frames.width_px) * static_cast<std::size_t>(frames.height_px);
	frames.images.assign(count, std::vector<std::uint16_t>(pixels));
	for (auto& image : frames.images)
		file.read(reinterpret_cast<char*>(image.data()),  // NOLINT: bytes
		          static_cast<std::streamsize>(pixels * sizeof(std::uint16_t)));
	return frames;
}
}  // namespace explore::test
