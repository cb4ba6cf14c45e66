#include <explore/memory/reach_pyramid.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace explore
{
namespace
{
constexpr int kMostCellsAround = 3;
constexpr int kMaxCells = 4;  // an axis, that one look into a rectangle takes
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
float lesser(float a, float b)
{
	return a < b ? a : b;
}

/** Each 2 × 2 cells, or what there is of them at the edges, joined. */
template <class Join>
std::vector<float> halved(const Grid& fine, const Join& join)
{
	const int columns = (fine.columns + 1) / 2, rows = (fine.rows + 1) / 2;
	std::vector<float> coarse(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
	for (int row = 0; row < rows; ++row)
	{
		const float* a = fine.values + static_cast<std::ptrdiff_t>(2 * row) * fine.columns;
		const float* b = 2 * row + 1 < fine.rows ? a + fine.columns : a;
		float* out = coarse.data() + static_cast<std::ptrdiff_t>(row) * columns;
		for (int i = 0; i < fine.columns / 2; ++i)
			out[i] = join(join(a[2 * i], a[2 * i + 1]), join(b[2 * i], b[2 * i + 1]));
		if (fine.columns % 2 != 0) out[columns - 1] = join(a[fine.columns - 1], b[fine.columns - 1]);
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

ReachPyramid::Level ReachPyramid::makeLevel(int columns, int rows, std::vector<float> farthest_m,
                                            std::vector<float> darkest_m)
{
	Level level{columns, rows, std::move(farthest_m), std::move(darkest_m), {}};
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
	static_assert(kFirstShift == 2);
	const std::vector<float> pairs = halved({rays.width_px, rays.height_px, rays.reach_m.data()}, farther);
	const Grid half{(rays.width_px + 1) / 2, (rays.height_px + 1) / 2, pairs.data()};
	std::vector<float> quarter = halved(half, farther);
	m_levels.push_back(makeLevel((half.columns + 1) / 2, (half.rows + 1) / 2, quarter, quarter));
	while (m_levels.back().columns > 1 || m_levels.back().rows > 1)
	{
		const Level& finer = m_levels.back();
		m_levels.push_back(makeLevel((finer.columns + 1) / 2, (finer.rows + 1) / 2,
		                             halved({finer.columns, finer.rows, finer.farthest_m.data()}, farther),
		                             halved({finer.columns, finer.rows, finer.darkest_m.data()}, lesser)));
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

ReachPyramid::CellRange ReachPyramid::cellsOver(const PixelRect& rect) const
{
	int shift = kFirstShift;
	const int size = std::max(rect.u1 - rect.u0, rect.v1 - rect.v0);
	while ((size >> shift) >= kMaxCells && shift < lastShift()) ++shift;
	return {&level(shift), rect.u0 >> shift, rect.v0 >> shift, rect.u1 >> shift, rect.v1 >> shift};
}

float ReachPyramid::farthestIn(const PixelRect& rect) const
{
	const PixelRect part = inImage(rect);
	if (part.u0 > part.u1 || part.v0 > part.v1) return 0.0F;
	const CellRange cells = cellsOver(part);
	float farthest_m = 0.0F;
	cells.forEach(
	    [&](std::size_t i)
	    {
		    farthest_m = farther(farthest_m, cells.level->farthest_m[i]);
		    return true;
	    });
	return farthest_m;
}

bool ReachPyramid::anyDarkIn(const PixelRect& rect) const
{
	const PixelRect part = inImage(rect);
	if (part.u0 > part.u1 || part.v0 > part.v1) return false;
	const CellRange cells = cellsOver(part);
	bool dark = false;
	cells.forEach(
	    [&](std::size_t i)
	    {
		    dark = cells.level->darkest_m[i] <= 0.0F;
		    return !dark;
	    });
	return dark;
}

ReachPyramid::Around ReachPyramid::around(float radius_px) const
{
	int shift = kFirstShift;
	while (static_cast<float>(kMostCellsAround << shift) < radius_px && shift < lastShift()) ++shift;
	const float cells =
	    std::clamp(std::ceil(radius_px / static_cast<float>(1 << shift)), 1.0F, static_cast<float>(kMostCellsAround));
	Around around;
	around.reach_m = m_rays->reach_m.data();
	around.farthest_m = level(shift).wider_farthest_m[static_cast<std::size_t>(cells) - 1].data();
	around.shift = shift;
	around.columns = level(shift).columns;
	around.width_px = m_width_px;
	around.height_px = m_height_px;
	around.radius_px = static_cast<int>(std::min(radius_px, kOutside_px)) + 1;
	return around;
}
}  // namespace explore
