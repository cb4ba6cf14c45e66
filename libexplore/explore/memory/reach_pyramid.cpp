#include <explore/memory/reach_pyramid.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace explore
{
namespace
{
constexpr int kFirstShift = 2;  // finer cells are not worth their making
constexpr int kMaxCells = 4;  // an axis, that one look into a rectangle takes

struct Grid
{
	const float* values;
	int columns, rows;
};

/** The largest of each 2 × 2 values, or of what there is of them. */
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
			out[i] = std::max(std::max(a[2 * i], a[2 * i + 1]), std::max(b[2 * i], b[2 * i + 1]));
		if (fine.columns % 2 != 0) out[columns - 1] = std::max(a[fine.columns - 1], b[fine.columns - 1]);
	}
	return coarse;
}

std::vector<float> widened(const Grid& grid)
{
	std::vector<float> wider(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
	for (int row = 0; row < grid.rows; ++row)
		for (int column = 0; column < grid.columns; ++column)
		{
			float farthest = 0.0F;
			for (int r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r)
				for (int c = std::max(column - 1, 0); c <= std::min(column + 1, grid.columns - 1); ++c)
					farthest = std::max(farthest, grid.values[r * grid.columns + c]);
			wider[static_cast<std::size_t>(row * grid.columns + column)] = farthest;
		}
	return wider;
}
}  // namespace

ReachPyramid::ReachPyramid(const FrameRays& rays) : m_width_px(rays.width_px), m_height_px(rays.height_px)
{
	Grid grid{rays.reach_m.data(), rays.width_px, rays.height_px};
	std::vector<float> below_first;
	for (int shift = 1; shift <= kFirstShift || grid.columns > 1 || grid.rows > 1; ++shift)
	{
		std::vector<float> values = halved(grid);
		grid = {values.data(), (grid.columns + 1) / 2, (grid.rows + 1) / 2};
		if (shift < kFirstShift)
			below_first = std::move(values);  // keeps its place, where `grid` looks
		else
			m_levels.push_back({grid.columns, grid.rows, std::move(values), widened(grid)});
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

float ReachPyramid::farthestIn(const PixelRect& rect) const
{
	const int u0 = std::max(rect.u0, 0), u1 = std::min(rect.u1, m_width_px - 1);
	const int v0 = std::max(rect.v0, 0), v1 = std::min(rect.v1, m_height_px - 1);
	if (u0 > u1 || v0 > v1) return 0.0F;
	int shift = kFirstShift;
	const int size = std::max(u1 - u0, v1 - v0);
	while ((size >> shift) >= kMaxCells && shift < lastShift()) ++shift;
	const Level& cells_of = level(shift);
	float farthest = 0.0F;
	for (int row = v0 >> shift; row <= v1 >> shift; ++row)
	{
		const float* cells = cells_of.reach_m.data() + static_cast<std::ptrdiff_t>(row) * cells_of.columns;
		for (int column = u0 >> shift; column <= u1 >> shift; ++column) farthest = std::max(farthest, cells[column]);
	}
	return farthest;
}

float ReachPyramid::Around::operator()(int u, int v) const
{
	// Moving a pixel into the image brings it nearer to every pixel of the image.
	const int column = std::clamp(u, 0, m_max_u) >> m_shift, row = std::clamp(v, 0, m_max_v) >> m_shift;
	return (*m_reach_m)[static_cast<std::size_t>(row * m_columns + column)];
}

ReachPyramid::Around ReachPyramid::around(float radius_px) const
{
	int shift = kFirstShift;
	while (static_cast<float>(1 << shift) < radius_px && shift < lastShift()) ++shift;
	Around around;
	around.m_reach_m = &level(shift).wider_reach_m;
	around.m_shift = shift;
	around.m_columns = level(shift).columns;
	around.m_max_u = m_width_px - 1;
	around.m_max_v = m_height_px - 1;
	return around;
}
}  // namespace explore
