// Finds the blocks of an infrared picture again in the projector's pattern.
#pragma once

#include <cstdint>
#include <vector>

namespace explore::simulation
{
struct SpeckleSearch
{
	int width_px = 0, height_px = 0;
	int least_px = 1, most_px = 90;  ///< whole disparities that are tried
	int threads = 1;
};

/** Disparity of each pixel [px], row-major, to a fraction by a parabola through the best three costs; 0 where the block
 *  around it is too dull, fits nowhere, or fits in two places. The outermost pixels have no whole block and give 0. */
std::vector<float> matchSpeckles(const std::vector<std::uint16_t>& infrared, const SpeckleSearch& search);
}  // namespace explore::simulation
