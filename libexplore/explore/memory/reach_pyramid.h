// The farthest that any ray saw in parts of the depth image, from small parts to large ones.
#pragma once

#include <explore/memory/frame_rays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <vector>

namespace explore
{
/** Pixels u0 … u1, v0 … v1, ends included; may reach beyond the image, or be empty. */
struct PixelRect
{
	int u0, v0, u1, v1;
};

class ReachPyramid
{
public:
	/** `rays` must outlive it. */
	explicit ReachPyramid(const FrameRays& rays);

	/** No pixel of the image in the rectangle reaches farther [m]; pixels around it may make it more. 0 outside of the
	 *  image. */
	[[nodiscard]] float farthestIn(const PixelRect& rect) const;
	/** The part of the rectangle that is in the image; empty ones have u0 > u1 or v0 > v1. */
	[[nodiscard]] PixelRect inImage(const PixelRect& rect) const;

	/** Whether some 4 × 4 pixels in or at the edge of the rectangle all have no return. */
	[[nodiscard]] bool anyDarkIn(const PixelRect& rect) const;

	/** For each pixel the farthest reach around it, one look-up a pixel: pixel (u, v), moved into the image where it is
	 * not in it, has farthest_m[(v >> shift) · columns + (u >> shift)]. From farther outside than radius_px nothing is
	 * around. */
	struct Around
	{
		const float* farthest_m = nullptr;
		int shift = 0, columns = 0, radius_px = 0;
		const float* reach_m = nullptr;  ///< of each pixel, as in FrameRays
		int width_px = 0, height_px = 0;

		/** 0 where all pixels around are outside of the image. */
		[[nodiscard]] float operator()(int u, int v) const
		{
			const int inner_u = std::clamp(u, 0, width_px - 1), inner_v = std::clamp(v, 0, height_px - 1);
			if (std::max(std::abs(u - inner_u), std::abs(v - inner_v)) > radius_px) return 0.0F;
			return farthest_m[(inner_v >> shift) * columns + (inner_u >> shift)];
		}
	};
	/** Around means: within ±radius_px, and some pixels farther. */
	[[nodiscard]] Around around(float radius_px) const;

private:
	/** Cells of 2^shift × 2^shift pixels. */
	struct Level
	{
		int columns = 0, rows = 0;
		std::vector<float> farthest_m;  ///< in each cell
		std::vector<float> darkest_m;   ///< the least of what is farthest in the 4 × 4 pixels of the cell
		/** In it and 1, 2 and 3 cells around it. */
		std::array<std::vector<float>, 3> wider_farthest_m;
	};
	static constexpr int kFirstShift = 2;  // finer cells are not worth keeping
	/** Cells of one level. */
	struct CellRange
	{
		const Level* level;
		int first_column, first_row, last_column, last_row;

		/** Calls visit(index) for each, until it returns false. */
		template <class Visit>
		void forEach(const Visit& visit) const
		{
			for (int row = first_row; row <= last_row; ++row)
				for (int column = first_column; column <= last_column; ++column)
				{
					const int index = row * level->columns + column;
					if (!visit(static_cast<std::size_t>(index))) return;
				}
		}
	};
	static Level makeLevel(int columns, int rows, std::vector<float> farthest_m, std::vector<float> darkest_m);
	/** The cells that a rectangle in the image, not empty, touches, of a level where they are few. */
	[[nodiscard]] CellRange cellsOver(const PixelRect& rect) const;
	[[nodiscard]] const Level& level(int shift) const;
	[[nodiscard]] int lastShift() const;

	const FrameRays* m_rays;
	int m_width_px, m_height_px;
	std::vector<Level> m_levels;  ///< by shift, up to a single cell
};
}  // namespace explore
