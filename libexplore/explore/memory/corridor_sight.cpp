#include <explore/memory/corridor_sight.h>

#include <algorithm>
#include <vector>

namespace explore
{
double clearAhead(const DepthFrame& frame)
{
	const DepthImage& image = frame.image;
	if (image.empty()) return 0;
	const int width_px = image.intrinsics.width_px, height_px = image.intrinsics.height_px;
	std::vector<float> depths_m;
	depths_m.reserve(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) / 50);
	for (int v = height_px * 9 / 20; v <= height_px * 11 / 20 && v < height_px; ++v)
		for (int u = width_px * 9 / 20; u <= width_px * 11 / 20 && u < width_px; ++u)
			depths_m.push_back(image.at(u, v));
	const auto middle = depths_m.begin() + static_cast<std::ptrdiff_t>(depths_m.size() / 2);
	std::nth_element(depths_m.begin(), middle, depths_m.end());
	return *middle;
}
}  // namespace explore
