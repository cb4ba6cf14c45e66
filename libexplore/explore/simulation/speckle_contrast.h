// Brightness made comparable: each pixel relative to the mean and the spread of the block around it.
#pragma once

#include <cstdint>
#include <vector>

namespace explore::simulation
{
constexpr int kBlock_px = 9;  ///< side of a block
constexpr int kHalfBlock_px = kBlock_px / 2;
constexpr int kLevels = 14;  ///< −14 … 14: squares of their differences over a block fit 16 bits
constexpr int kLevelsPerSigma = 6;

struct ContrastImage
{
	std::vector<std::uint8_t> level;  ///< kLevels + rounded (value − mean) · kLevelsPerSigma / sigma, clamped
	std::vector<float> sigma;         ///< of the block; 0 where it is not whole
};

/** Of a row-major image. */
ContrastImage contrastOf(const std::vector<std::uint16_t>& image, int width_px, int height_px, int threads);
}  // namespace explore::simulation
