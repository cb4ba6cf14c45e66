#include <explore/memory/key_range.h>
#include <explore/memory/voxel_block.h>

#include <cmath>

namespace explore
{
KeyRange keysBetween(double low_m, double high_m, double resolution_m)
{
	constexpr double kFace = 1e-9;  // of a voxel: heights that near to a face are on it
	if (!(low_m < high_m)) return {};
	return {kOriginKey + static_cast<int>(std::floor(low_m / resolution_m + kFace)),
	        kOriginKey + static_cast<int>(std::ceil(high_m / resolution_m - kFace)) - 1};
}
}  // namespace explore
