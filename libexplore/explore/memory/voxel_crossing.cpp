#include <explore/core/vector_code.h>
#include <explore/memory/voxel_crossing.h>

#include <array>

namespace explore
{
namespace
{
constexpr int kLanes = FrameRays::kLanes;
using Triple = std::array<float, 3>;

/** The planes of a voxel as rays meet them, each axis counted from the camera toward the voxel. On an axis where the
 *  camera is between the planes, rays that go down the axis leave through another plane than those that go up. */
struct VoxelPlanes
{
	Triple sign, near, far_up, far_down;
	Triple fold;  ///< what turns a direction down the axis into one toward the far plane: −1, or 1 where there is none
	bool camera_between = false;  ///< on any axis
};

VoxelPlanes planesOf(const Eigen::Array3f& low)
{
	VoxelPlanes planes{};
	for (std::size_t i = 0; i < 3; ++i)
	{
		const float corner = low[static_cast<Eigen::Index>(i)];
		// A ray along a face belongs to the voxel above it, as its points do.
		const bool between = corner <= 0.0F && corner > -1.0F, below = corner <= -1.0F;
		planes.sign[i] = below ? -1.0F : 1.0F;
		planes.near[i] = between ? -1.0F : (below ? -corner - 1.0F : corner);
		planes.far_up[i] = below ? -corner : corner + 1.0F;
		planes.far_down[i] = between ? -corner : planes.far_up[i];
		planes.fold[i] = between ? -1.0F : 1.0F;
		planes.camera_between = planes.camera_between || between;
	}
	return planes;
}

/** Directions of a row's rays: start + left · slope. */
struct RowDirections
{
	Triple start, slope;
};

RowDirections directionsOf(const FrameRays& rays, const VoxelPlanes& planes, int v)
{
	RowDirections row{};
	for (std::size_t i = 0; i < 3; ++i)
	{
		const Eigen::Vector3f axis = planes.sign[i] * rays.voxels_from_camera.row(static_cast<Eigen::Index>(i));
		row.start[i] = axis.x() + axis.z() * rays.up[static_cast<std::size_t>(v)];
		row.slope[i] = axis.y();
	}
	return row;
}

/** One axis of a direction, and the plane through which it leaves. */
struct AxisWay
{
	float along, far;
};
template <bool Between>
[[gnu::always_inline]] inline AxisWay wayAlong(const VoxelPlanes& planes, std::size_t axis, float direction)
{
	if constexpr (!Between) return {direction, planes.far_up[axis]};
	const bool down = direction < 0.0F;
	return {down ? direction * planes.fold[axis] : direction, down ? planes.far_down[axis] : planes.far_up[axis]};
}

/** Of kLanes pixels. A ray that crosses the voxel passes each near plane before any far one; which of two planes comes
 *  first can be said without a division. */
template <bool Between>
[[gnu::always_inline]] inline bool anyLaneCrosses(const VoxelPlanes& planes, const RowDirections& row,
                                                  const float* left, const float* reach_m)
{
	int any = 0;
	for (int k = 0; k < kLanes; ++k)
	{
		const auto [x, far_x] = wayAlong<Between>(planes, 0, row.start[0] + left[k] * row.slope[0]);
		const auto [y, far_y] = wayAlong<Between>(planes, 1, row.start[1] + left[k] * row.slope[1]);
		const auto [z, far_z] = wayAlong<Between>(planes, 2, row.start[2] + left[k] * row.slope[2]);
		const int leaves = static_cast<int>(x * reach_m[k] > far_x) | static_cast<int>(y * reach_m[k] > far_y) |
		                   static_cast<int>(z * reach_m[k] > far_z);
		const int enters =
		    static_cast<int>(planes.near[0] * y < far_y * x) & static_cast<int>(planes.near[0] * z < far_z * x) &
		    static_cast<int>(planes.near[1] * x < far_x * y) & static_cast<int>(planes.near[1] * z < far_z * y) &
		    static_cast<int>(planes.near[2] * x < far_x * z) & static_cast<int>(planes.near[2] * y < far_y * z);
		any |= leaves & enters;
	}
	return any != 0;
}

[[gnu::always_inline]] inline bool anyReaches(const float* reach_m, float depth_m)
{
	int any = 0;
	for (int k = 0; k < kLanes; ++k) any |= static_cast<int>(reach_m[k] > depth_m);
	return any != 0;
}

/** What to look for, where. */
struct Search
{
	const FrameRays* rays;
	VoxelPlanes planes;
	PixelRect rect;
	float depth_m;  ///< rays that reach no farther do not matter
};

template <bool Between>
[[gnu::always_inline]] inline void search(const Search& search, bool& found)
{
	const FrameRays& rays = *search.rays;
	found = false;
	for (int v = search.rect.v0; v <= search.rect.v1 && !found; ++v)
	{
		const RowDirections row = directionsOf(rays, search.planes, v);
		const float* reach_m = rays.rowOfReach(v);
		for (int u = search.rect.u0; u <= search.rect.u1 && !found; u += kLanes)
			if (anyReaches(reach_m + u, search.depth_m))
				found = anyLaneCrosses<Between>(search.planes, row, rays.left.data() + u, reach_m + u);
	}
}
EXPLORE_VECTOR_CODE(searchAside, search<false>, (const Search& what, bool& found), (what, found))
EXPLORE_VECTOR_CODE(searchBetween, search<true>, (const Search& what, bool& found), (what, found))
}  // namespace

bool anyRayCrosses(const FrameRays& rays, const GridKey& voxel, const PixelRect& rect, float depth_m)
{
	const Search what{&rays, planesOf((voxel - rays.origin_key).cast<float>() - rays.origin.array()), rect, depth_m};
	bool found = false;
	if (what.planes.camera_between)
		searchBetween(what, found);
	else
		searchAside(what, found);
	return found;
}
}  // namespace explore
