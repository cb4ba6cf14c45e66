#include "import_fixture.h"

#include <zlib.h>

#include <cmath>

namespace explore::test
{
namespace
{
std::string bigEndian(std::uint32_t number, int bytes)
{
	std::string text;
	for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += static_cast<char>((number >> shift) & 0xffU);
	return text;
}

std::string pngChunk(const std::string& type, const std::string& content)
{
	const std::string body = type + content;
	const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
	return bigEndian(static_cast<std::uint32_t>(content.size()), 4) + body +
	       bigEndian(static_cast<std::uint32_t>(crc), 4);
}

}  // namespace

void writePng(const std::filesystem::path& path, const DepthImage& image, double counts_per_m)
{
	const int width = image.intrinsics.width_px, height = image.intrinsics.height_px;
	std::string rows;
	for (int v = 0; v < height; ++v)
	{
		rows += '\0';  // no filter
		for (int u = 0; u < width; ++u)
			rows += bigEndian(static_cast<std::uint32_t>(std::lround(image.at(u, v) * counts_per_m)), 2);
	}
	uLongf size = compressBound(rows.size());
	std::string packed(size, '\0');
	ASSERT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
	                   rows.size()),
	          Z_OK);
	packed.resize(size);
	const std::string header = bigEndian(static_cast<std::uint32_t>(width), 4) +
	                           bigEndian(static_cast<std::uint32_t>(height), 4) +
	                           std::string("\x10\0\0\0\0", 5);  // 16 bits, greyscale
	writeBytes(path, "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + pngChunk("IDAT", packed) + pngChunk("IEND", ""));
}

ImportConfig importConfigOf(const DepthImage& image, double counts_per_m)
{
	ImportConfig config;
	config.fx_px = image.intrinsics.fx_px, config.fy_px = image.intrinsics.fy_px;
	config.cx_px = image.intrinsics.cx_px, config.cy_px = image.intrinsics.cy_px;
	config.depth_scale_m = 1.0 / counts_per_m;
	return config;
}

void importTo(const std::filesystem::path& log, const Recording& recording, const ImportConfig& config)
{
	RawlogWriter writer(log);
	importRecording(recording, config, writer);
	writer.close();
}

}  // namespace explore::test
