// Where in the image, and how deep, a cube of voxels is seen.
#pragma once

#include <explore/memory/frame_rays.h>
#include <explore/memory/reach_pyramid.h>

namespace explore
{
constexpr float kInFront_m = 1e-6F;        ///< where a cube reaches behind the camera, its view begins here
constexpr float kFarOutside_px = 1 << 14;  ///< larger than any image; floats hold pixels beyond it to 1/500
constexpr float kRounding_px = 0.01F;

/** The last whole pixel not above; the bounds keep the conversion defined. Plain comparisons, which loops vectorise. */
[[gnu::always_inline]] inline int pixelBelow(float pixel)
{
	const float low = pixel < kFarOutside_px ? pixel : kFarOutside_px;
	const float bounded = low < -kFarOutside_px ? -kFarOutside_px : low;
	return static_cast<int>(bounded + kFarOutside_px) - static_cast<int>(kFarOutside_px);
}

/** The box in camera axes that holds the cube [m]. */
struct CubeView
{
	Eigen::Vector3f center, half;

	[[nodiscard]] float nearest_m() const { return center.x() - half.x(); }
	[[nodiscard]] float farthest_m() const { return center.x() + half.x(); }
};

/** Half the extent in camera axes of a cube with that edge in voxels. */
Eigen::Vector3f halfExtent(const FrameRays& rays, float edge_voxels);

/** The pixels whose rays may cross the cube, which is not all behind the camera; they may be outside of the image. */
PixelRect rectOf(const FrameRays& rays, const CubeView& cube);
}  // namespace explore
