#include <explore/memory/cube_view.h>

#include <algorithm>

namespace explore
{
namespace
{

struct Interval
{
	int first, last;
};

/** Columns (axis 1) or rows (axis 2) with centres in the view of a cube; `per_nearest`, `per_farthest` are 1 / depth.
 */
Interval pixelsAlong(const FrameRays& rays, const CubeView& cube, int axis, float per_nearest, float per_farthest)
{
	const float low = cube.center[axis] - cube.half[axis], high = cube.center[axis] + cube.half[axis];
	const float scale = rays.px_per_tangent[axis - 1], at_axis = rays.axis_px[axis - 1];
	const float a = at_axis + scale * low * (low < 0.0F ? per_nearest : per_farthest);
	const float b = at_axis + scale * high * (high > 0.0F ? per_nearest : per_farthest);
	return {pixelBelow(std::min(a, b) - kRounding_px) + 1, pixelBelow(std::max(a, b) + kRounding_px)};
}
}  // namespace

Eigen::Vector3f halfExtent(const FrameRays& rays, float edge_voxels)
{
	return rays.camera_from_voxels.cwiseAbs().rowwise().sum() * (0.5F * edge_voxels);
}

PixelRect rectOf(const FrameRays& rays, const CubeView& cube)
{
	const float per_nearest = 1.0F / std::max(cube.nearest_m(), kInFront_m), per_farthest = 1.0F / cube.farthest_m();
	const Interval columns = pixelsAlong(rays, cube, 1, per_nearest, per_farthest);
	const Interval rows = pixelsAlong(rays, cube, 2, per_nearest, per_farthest);
	return {columns.first, rows.first, columns.last, rows.last};
}
}  // namespace explore
