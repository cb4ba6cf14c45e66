#include <explore/memory/reach_pyramid.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace explore
{
namespace
{
constexpr int kFirstShift = 2;  // finer cells are not worth keeping
constexpr int kMostCellsAround = 3;
constexpr int kMaxCells = 4;    // an axis, that one look into a rectangle takes
constexpr float kOutside_px = 1e6F;

struct Grid
{
	int columns, rows;
	const float* values;
};

float farther(float a, float b)
{
	return a < b ? b : a;
}

/** The farthest of each 2 × 2 cells, or of what there is of them at the edges. */
std::vector<float> halved(const Grid& fine)
{
	const int columns = (fine.columns + 1) / 2, rows = (fine.rows + 1) / 2;
	std::vector<float> coarse(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
	for (int row = 0; row < rows; ++row)
	{
		const float* a = fine.values + static_cast<std::ptrdiff_t>(2 * row) * fine.columns;
		const float* b = 2 * row + 1 < fine.rows ? a + fine.columns : a;
		float* out = coarse.data() + static_cast<std::ptrdiff_t>(row) * columns;
		for (int i = 0; i < fine.columns / 2; ++i)
			out[i] = farther(farther(a[2 * i], a[2 * i + 1]), farther(b[2 * i], b[2 * i + 1]));
		if (fine.columns % 2 != 0) out[columns - 1] = farther(a[fine.columns - 1], b[fine.columns - 1]);
	}
	return coarse;
}

/** The farthest of each cell and its eight neighbours. */
std::vector<float> widened(const Grid& grid)
{
	const auto count = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
	std::vector<float> across(grid.values, grid.values + count);
	for (int row = 0; row < grid.rows; ++row)
	{
		const float* in = grid.values + static_cast<std::ptrdiff_t>(row) * grid.columns;
		float* out = across.data() + static_cast<std::ptrdiff_t>(row) * grid.columns;
		for (int i = 1; i < grid.columns; ++i) out[i] = farther(in[i], in[i - 1]);
		for (int i = 0; i + 1 < grid.columns; ++i) out[i] = farther(out[i], in[i + 1]);
	}
	std::vector<float> wider = across;
	const auto columns = static_cast<std::size_t>(grid.columns);
	for (std::size_t i = columns; i < count; ++i) wider[i] = farther(wider[i], across[i - columns]);
	for (std::size_t i = 0; i + columns < count; ++i) wider[i] = farther(wider[i], across[i + columns]);
	return wider;
}
}  // namespace

ReachPyramid::Level ReachPyramid::makeLevel(std::vector<float> farthest_m, int columns, int rows)
{
	Level level{columns, rows, std::move(farthest_m), {}};
	Grid grid{columns, rows, level.farthest_m.data()};
	for (std::vector<float>& wider : level.wider_farthest_m)
	{
		wider = widened(grid);
		grid.values = wider.data();
	}
	return level;
}

ReachPyramid::ReachPyramid(const FrameRays& rays)
    : m_rays(&rays), m_width_px(rays.width_px), m_height_px(rays.height_px)
{
	Grid finer{rays.width_px, rays.height_px, rays.reach_m.data()};
	std::vector<float> below_first;
	for (int shift = 1; shift <= kFirstShift || finer.columns > 1 || finer.rows > 1; ++shift)
	{
		std::vector<float> farthest_m = halved(finer);
		finer = {(finer.columns + 1) / 2, (finer.rows + 1) / 2, farthest_m.data()};  // moving a vector leaves its data there
		if (shift < kFirstShift)
			below_first = std::move(farthest_m);
		else
			m_levels.push_back(makeLevel(std::move(farthest_m), finer.columns, finer.rows));
	}
}

const ReachPyramid::Level& ReachPyramid::level(int shift) const
{
	return m_levels[static_cast<std::size_t>(shift - kFirstShift)];
}

int ReachPyramid::lastShift() const
{
	return kFirstShift + static_cast<int>(m_levels.size()) - 1;
}

PixelRect ReachPyramid::inImage(const PixelRect& rect) const
{
	return {std::max(rect.u0, 0), std::max(rect.v0, 0), std::min(rect.u1, m_width_px - 1),
	        std::min(rect.v1, m_height_px - 1)};
}

float ReachPyramid::farthestIn(const PixelRect& rect) const
{
	const PixelRect part = inImage(rect);
	if (part.u0 > part.u1 || part.v0 > part.v1) return 0.0F;
	int shift = kFirstShift;
	const int size = std::max(part.u1 - part.u0, part.v1 - part.v0);
	while ((size >> shift) >= kMaxCells && shift < lastShift()) ++shift;
	const Level& cells = level(shift);
	float farthest_m = 0.0F;
	for (int row = part.v0 >> shift; row <= part.v1 >> shift; ++row)
		for (int column = part.u0 >> shift; column <= part.u1 >> shift; ++column)
			farthest_m = farther(farthest_m, cells.farthest_m[static_cast<std::size_t>(row * cells.columns + column)]);
	return farthest_m;
}

ReachPyramid::Around ReachPyramid::around(float radius_px) const
{
	int shift = kFirstShift;
	while (static_cast<float>(kMostCellsAround << shift) < radius_px && shift < lastShift()) ++shift;
	const float cells = std::clamp(std::ceil(radius_px / static_cast<float>(1 << shift)), 1.0F, static_cast<float>(kMostCellsAround));
	Around around;
	around.m_reach_m = m_rays->reach_m.data();
	around.m_farthest_m = level(shift).wider_farthest_m[static_cast<std::size_t>(cells) - 1].data();
	around.m_shift = shift;
	around.m_columns = level(shift).columns;
	around.m_width_px = m_width_px;
	around.m_height_px = m_height_px;
	around.m_radius_px = static_cast<int>(std::min(radius_px, kOutside_px)) + 1;
	return around;
}
}  // namespace explore
