#include <explore/sinks/report/depth_picture.h>
#include <mrpt/img/CImage.h>
#include <mrpt/io/CMemoryStream.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr int kQuality = 45;  // of the JPEG: the lines over it are drawn by the page, and stay sharp

struct Box
{
	int left = 0, top = 0, right = 0, bottom = 0;  ///< pixels, right and bottom not included
};

/** Of the pixels in the box; 0 where fewer than half have a return. */
double meanDepth(const DepthImage& image, const Box& box)
{
	double sum = 0.0;
	int found = 0, all = 0;
	for (int v = box.top; v < box.bottom; ++v)
		for (int u = box.left; u < box.right; ++u)
		{
			const float depth = image.at(u, v);
			++all;
			if (depth <= 0.0F) continue;
			sum += depth;
			++found;
		}
	return 2 * found >= all && found > 0 ? sum / found : 0.0;
}

std::uint8_t greyOf(double depth_m, double max_range_m)
{
	if (depth_m <= 0.0) return 0;
	const double share = std::clamp(depth_m / max_range_m, 0.0, 1.0);
	return static_cast<std::uint8_t>(std::lround(DepthGrey::kNear + share * (DepthGrey::kFar - DepthGrey::kNear)));
}
}  // namespace

std::string depthJpeg(const DepthImage& image, double max_range_m, int width_px)
{
	if (image.empty()) return "";
	const int columns = image.intrinsics.width_px, rows = image.intrinsics.height_px;
	const int width = std::min(width_px, columns), height = std::max(1, rows * width / columns);
	mrpt::img::CImage grey(static_cast<unsigned>(width), static_cast<unsigned>(height), mrpt::img::CH_GRAY);
	for (int y = 0; y < height; ++y)
		for (int x = 0; x < width; ++x)
		{
			const Box box{x * columns / width, y * rows / height, (x + 1) * columns / width, (y + 1) * rows / height};
			*grey.ptr<std::uint8_t>(static_cast<unsigned>(x), static_cast<unsigned>(y)) =
			    greyOf(meanDepth(image, box), max_range_m);
		}
	mrpt::io::CMemoryStream file;
	grey.saveToStreamAsJPEG(file, kQuality);
	return {static_cast<const char*>(file.getRawBufferData()), static_cast<std::size_t>(file.getTotalBytesCount())};
}
}  // namespace explore
