#include <explore/simulation/parallel_rows.h>
#include <explore/simulation/speckle_contrast.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace explore::simulation
{
namespace
{
/** Sums over the rows of a block, a column each. */
struct ColumnSums
{
	std::vector<std::uint32_t> value, square;

	ColumnSums(const std::vector<std::uint16_t>& image, std::size_t width, std::size_t middle_row)
	    : value(width), square(width)
	{
		for (std::size_t v = middle_row - kHalfBlock_px; v <= middle_row + kHalfBlock_px; ++v)
			for (std::size_t u = 0; u < width; ++u)
			{
				const std::uint32_t counts = image[v * width + u];
				value[u] += counts;
				square[u] += counts * counts;
			}
	}
};

void contrastRow(const std::vector<std::uint16_t>& image, std::size_t width, std::size_t row, ContrastImage& out)
{
	constexpr float kArea = kBlock_px * kBlock_px;
	const ColumnSums columns(image, width, row);
	for (std::size_t u = kHalfBlock_px; u + kHalfBlock_px < width; ++u)
	{
		std::uint32_t sum = 0, squares = 0;
		for (std::size_t i = u - kHalfBlock_px; i <= u + kHalfBlock_px; ++i)
		{
			sum += columns.value[i];
			squares += columns.square[i];
		}
		const float mean = static_cast<float>(sum) / kArea;
		const float sigma = std::sqrt(std::max(0.0F, static_cast<float>(squares) / kArea - mean * mean));
		const float relative =
		    (static_cast<float>(image[row * width + u]) - mean) * kLevelsPerSigma / std::max(sigma, 0.1F);
		out.sigma[row * width + u] = sigma;
		out.level[row * width + u] = static_cast<std::uint8_t>(
		    std::floor(std::clamp(relative, -1.0F * kLevels, 1.0F * kLevels) + kLevels + 0.5F));
	}
}
}  // namespace

ContrastImage contrastOf(const std::vector<std::uint16_t>& image, int width_px, int height_px, int threads)
{
	ContrastImage out{std::vector<std::uint8_t>(image.size(), kLevels), std::vector<float>(image.size())};
	if (width_px < kBlock_px || height_px < kBlock_px) return out;
	parallelRows(height_px - 2 * kHalfBlock_px, 16, threads,
	             [&](int first, int last)
	             {
		             for (int v = first + kHalfBlock_px; v < last + kHalfBlock_px; ++v)
			             contrastRow(image, static_cast<std::size_t>(width_px), static_cast<std::size_t>(v), out);
	             });
	return out;
}
}  // namespace explore::simulation
