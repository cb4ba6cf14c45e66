#include "depth_png.h"

#include <explore/core/errors.h>
#include <mrpt/img/CImage.h>

#include <array>
#include <cstring>
#include <fstream>
#include <string>

namespace explore
{
namespace
{
[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what)
{
	throw InputError(path.string() + ": " + what + "; a greyscale PNG with 16 bits a pixel is needed");
}

/** Looks at the bytes that only a complete PNG has: its signature and its last chunk. The decoder returns an image even
 *  for half a file. */
void checkComplete(const std::filesystem::path& path)
{
	constexpr std::array<unsigned char, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
	constexpr std::array<unsigned char, 8> kEnd = {'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82};
	std::array<unsigned char, 8> bytes{};
	const auto read = [&](std::ifstream& file) { file.read(reinterpret_cast<char*>(bytes.data()), bytes.size()); };
	std::ifstream file(path, std::ios::binary);
	if (!file) refuse(path, std::strerror(errno));
	read(file);
	if (!file || bytes != kSignature) refuse(path, "is no PNG file");
	file.seekg(-static_cast<std::streamoff>(kEnd.size()), std::ios::end);
	read(file);
	if (!file || bytes != kEnd) refuse(path, "is cut off");
}
}  // namespace

mrpt::math::CMatrix_u16 readDepthPng(const std::filesystem::path& path)
{
	checkComplete(path);
	mrpt::img::CImage image;
	if (!image.loadFromFile(path.string()) || image.isEmpty()) refuse(path, "cannot be decoded");
	if (image.isColor()) refuse(path, "is a colour image");
	if (image.getPixelDepth() != mrpt::img::PixelDepth::D16U) refuse(path, "has 8 bits a pixel");
	const auto width = static_cast<unsigned>(image.getWidth()), height = static_cast<unsigned>(image.getHeight());
	mrpt::math::CMatrix_u16 counts(static_cast<int>(height), static_cast<int>(width));
	for (unsigned v = 0; v < height; ++v)
		std::memcpy(&counts(static_cast<int>(v), 0), image.ptrLine<std::uint16_t>(v), width * sizeof(std::uint16_t));
	return counts;
}
}  // namespace explore
