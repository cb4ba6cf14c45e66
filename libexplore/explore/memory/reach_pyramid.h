// The farthest that any ray saw in parts of the depth image, from small parts to large ones.
#pragma once

#include <explore/memory/frame_rays.h>

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
	explicit ReachPyramid(const FrameRays& rays);

	/** No less than the farthest reach [m] of any pixel of the image in the rectangle, and more only by the pixels
	 *  around it; 0 when it is outside of the image. */
	[[nodiscard]] float farthestIn(const PixelRect& rect) const;

	/** Of all pixels within ±radius_px of a pixel and some farther ones: one look-up a pixel. */
	class Around
	{
	public:
		/** (u, v) need not be in the image. */
		[[nodiscard]] float operator()(int u, int v) const;

	private:
		friend ReachPyramid;
		const std::vector<float>* m_reach_m = nullptr;
		int m_shift = 0, m_columns = 0, m_max_u = 0, m_max_v = 0;
	};
	[[nodiscard]] Around around(float radius_px) const;

private:
	/** Cells of 2^shift × 2^shift pixels. */
	struct Level
	{
		int columns = 0, rows = 0;
		std::vector<float> reach_m;         ///< farthest in each cell
		std::vector<float> wider_reach_m;  ///< farthest in it and its eight neighbours
	};
	[[nodiscard]] const Level& level(int shift) const;
	[[nodiscard]] int lastShift() const;

	int m_width_px, m_height_px;
	std::vector<Level> m_levels;  ///< by shift, up to a single cell
};
}  // namespace explore
