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
	Triple sign{}, near{}, far_up{}, far_down{};
	Triple
	    fold{};  ///< what turns a direction down the axis into one toward the far plane: −1, or 1 where there is none
	bool camera_between = false;  ///< on any axis
};

/** `corner` is the voxel's lower one on that axis, seen from the camera. */
[[gnu::always_inline]] inline void setAxis(VoxelPlanes& planes, std::size_t axis, float corner)
{
	// A ray along a face belongs to the voxel above it, as its points do.
	const bool below = corner <= -1.0F, between = !below && corner <= 0.0F;
	const float far = below ? -corner : corner + 1.0F;
	planes.sign[axis] = below ? -1.0F : 1.0F;
	planes.near[axis] = between ? -1.0F : far - 1.0F;
	planes.far_up[axis] = far;
	planes.far_down[axis] = between ? -corner : far;
	planes.fold[axis] = between ? -1.0F : 1.0F;
	planes.camera_between = planes.camera_between || between;
}

/** Directions of a row's rays: start + left · slope, with the planes' signs. */
struct RowDirections
{
	Triple start, slope;
};

[[gnu::always_inline]] inline RowDirections directionsOf(const FrameRays& rays, const Triple& sign, int v)
{
	const Eigen::Matrix3f& turn = rays.voxels_from_camera;
	const float up = rays.up[static_cast<std::size_t>(v)];
	return {{sign[0] * (turn(0, 0) + turn(0, 2) * up), sign[1] * (turn(1, 0) + turn(1, 2) * up),
	         sign[2] * (turn(2, 0) + turn(2, 2) * up)},
	        {sign[0] * turn(0, 1), sign[1] * turn(1, 1), sign[2] * turn(2, 1)}};
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
	const FrameRays* rays = nullptr;
	VoxelPlanes planes;
	PixelRect rect{};
	float depth_m = 0;  ///< rays that reach no farther do not matter
};

template <bool Between>
[[gnu::always_inline]] inline void search(const Search& search, bool& found)
{
	const FrameRays& rays = *search.rays;
	found = false;
	for (int v = search.rect.v0; v <= search.rect.v1; ++v)
	{
		const float* reach_m = rays.rowOfReach(v);
		for (int u = search.rect.u0; u <= search.rect.u1; u += kLanes)
		{
			if (!anyReaches(reach_m + u, search.depth_m)) continue;  // most do not
			const RowDirections row = directionsOf(rays, search.planes.sign, v);
			found = anyLaneCrosses<Between>(search.planes, row, rays.left.data() + u, reach_m + u);
			if (found) return;
		}
	}
}
EXPLORE_VECTOR_CODE(searchAside, search<false>, (const Search& what, bool& found), (what, found))
EXPLORE_VECTOR_CODE(searchBetween, search<true>, (const Search& what, bool& found), (what, found))
}  // namespace

bool anyRayCrosses(const FrameRays& rays, const GridKey& voxel, const PixelRect& rect, float depth_m)
{
	Search what;
	what.rays = &rays;
	what.rect = rect;
	what.depth_m = depth_m;
	for (std::size_t i = 0; i < 3; ++i)
	{
		const auto axis = static_cast<Eigen::Index>(i);
		setAxis(what.planes, i, static_cast<float>(voxel[axis] - rays.origin_key[axis]) - rays.origin[axis]);
	}
	bool found = false;
	if (what.planes.camera_between)
		searchBetween(what, found);
	else
		searchAside(what, found);
	return found;
}
}  // namespace explore
