// The farthest that any ray saw in parts of the depth image, from small parts to large ones.
#pragma once

#include <explore/memory/frame_rays.h>

#include <algorithm>
#include <array>
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

	/** What is seen at and around a pixel, by a look-up or two. */
	class Around
	{
	public:
		struct Sight
		{
			float farthest_m;  ///< no pixel around reaches farther; 0 where none of them is in the image
			float reach_m;     ///< of the pixel itself, or of the image's nearest to it
			bool in_image;
		};
		/** (u, v) need not be in the image. */
		[[nodiscard]] Sight operator()(int u, int v) const
		{
			// Moving a pixel into the image brings it nearer to every pixel of the image.
			const int inner_u = std::clamp(u, 0, m_width_px - 1), inner_v = std::clamp(v, 0, m_height_px - 1);
			const int moved_px = std::max(std::abs(u - inner_u), std::abs(v - inner_v));
			const float farthest_m = m_farthest_m[(inner_v >> m_shift) * m_columns + (inner_u >> m_shift)];
			return {moved_px > m_radius_px ? 0.0F : farthest_m, m_reach_m[inner_v * m_width_px + inner_u],
			        moved_px == 0};
		}

	private:
		friend ReachPyramid;
		const float *m_reach_m = nullptr, *m_farthest_m = nullptr;
		int m_shift = 0, m_columns = 0, m_width_px = 0, m_height_px = 0, m_radius_px = 0;
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
