#include <explore/memory/ray_passes.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace explore
{
namespace
{
constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kParallel = 1e-12F;
constexpr float kInFront_m = 1e-6F;  // where a cube reaches behind the camera, its view begins here

/** What a cube of voxels looks like from the camera. */
struct CubeView
{
	Eigen::Vector3f center, half;  ///< camera axes [m]; the box that holds the cube
	[[nodiscard]] float nearest_m() const { return center.x() - half.x(); }
	[[nodiscard]] float farthest_m() const { return center.x() + half.x(); }
};

/** Half the extent in camera axes of a cube with that edge in voxels. */
Eigen::Vector3f halfExtent(const FrameRays& rays, float edge_voxels)
{
	return rays.camera_from_voxels.cwiseAbs().rowwise().sum() * (0.5F * edge_voxels);
}

/** The pixels whose rays may cross the cube. */
PixelRect rectOf(const FrameRays& rays, const CubeView& cube)
{
	const float nearest_m = std::max(cube.nearest_m(), kInFront_m);
	const auto tangent = [&](int axis, float side)
	{
		const float across = cube.center[axis] + side * cube.half[axis];
		return across / (across * side > 0.0F ? nearest_m : cube.farthest_m());
	};
	const auto limits = [&](int axis)
	{
		const float a = rays.axis_px[axis - 1] + rays.px_per_tangent[axis - 1] * tangent(axis, 1.0F);
		const float b = rays.axis_px[axis - 1] + rays.px_per_tangent[axis - 1] * tangent(axis, -1.0F);
		// A pixel of slack for rounding; the bounds keep the conversion defined.
		const auto pixel = [](float value) { return static_cast<int>(std::clamp(value, -1e6F, 1e6F)); };
		return std::pair(pixel(std::min(a, b)) - 1, pixel(std::max(a, b)) + 1);
	};
	const auto [u0, u1] = limits(1);
	const auto [v0, v1] = limits(2);
	return {u0, v0, u1, v1};
}

/** Decides about the voxels of one frame. */
class PassFinder
{
public:
	PassFinder(const FrameRays& rays, const ReachPyramid& pyramid)
	    : m_rays(rays),
	      m_pyramid(pyramid),
	      m_voxel_half(halfExtent(rays, 1.0F)),
	      m_block_half(halfExtent(rays, kBlockEdge)),
	      // A pixel's ray misses its own place by up to 0.71 pixels and must still cross the voxel's inscribed sphere.
	      m_sure_depth_m(0.5F * rays.camera_from_voxels.col(0).norm() * rays.px_per_tangent.abs().minCoeff() / 0.75F)
	{
	}

	/** Whether rays may pass through any voxel of the block. */
	[[nodiscard]] bool mayPass(const GridKey& block) const
	{
		const CubeView view = viewOf(block);
		return view.farthest_m() > 0.0F && m_pyramid.farthestIn(rectOf(m_rays, view)) > view.nearest_m();
	}

	/** The voxels of the block, but for those in `hits`, that rays pass through. */
	[[nodiscard]] VoxelBits passesOf(const GridKey& block, const VoxelBits& hits) const
	{
		VoxelBits passes;
		const CubeView view = viewOf(block);
		const auto around = m_pyramid.around(widestVoxel_px(view));
		const Eigen::Vector3f first = m_rays.inCamera(block * kBlockEdge, Eigen::Vector3f::Constant(0.5F));
		for (int z = 0; z < kBlockEdge; ++z)
			for (int y = 0; y < kBlockEdge; ++y)
			{
				const Eigen::Vector3f row_start = first + m_rays.camera_from_voxels.rightCols<2>() * Eigen::Vector2f(y, z);
				for (int x = 0; x < kBlockEdge; ++x)
				{
					const int place = placeInBlock(x, y, z);
					if (hits.test(place)) continue;
					const Eigen::Vector3f center = row_start + static_cast<float>(x) * m_rays.camera_from_voxels.col(0);
					if (passes_(block * kBlockEdge + GridKey(x, y, z), center, around)) passes.set(place);
				}
			}
		return passes;
	}

private:
	[[nodiscard]] CubeView viewOf(const GridKey& block) const
	{
		return {m_rays.inCamera(block * kBlockEdge, Eigen::Vector3f::Constant(0.5F * kBlockEdge)), m_block_half};
	}

	/** How far from its centre's pixel any voxel of a block may be seen. */
	[[nodiscard]] float widestVoxel_px(const CubeView& block) const
	{
		const float nearest_m = block.nearest_m();
		if (nearest_m < kInFront_m) return kInfinite;
		const float tangent = (block.center.tail<2>().cwiseAbs() + block.half.tail<2>()).maxCoeff() / nearest_m;
		return m_rays.px_per_tangent.abs().maxCoeff() * (m_voxel_half.tail<2>().maxCoeff() + tangent * m_voxel_half.x()) /
		           nearest_m + 2.0F;
	}

	[[nodiscard]] bool passes_(const GridKey& voxel, const Eigen::Vector3f& center, const ReachPyramid::Around& around) const
	{
		const float depth_m = center.x();
		if (depth_m + m_voxel_half.x() <= 0.0F) return false;
		const float nearest_m = depth_m - m_voxel_half.x();
		if (nearest_m >= kInFront_m)
		{
			const Eigen::Array2f pixel = m_rays.axis_px + m_rays.px_per_tangent * center.tail<2>().array() / depth_m;
			const int u = static_cast<int>(std::clamp(pixel.x() + 0.5F, -1e6F, 1e6F) );
			const int v = static_cast<int>(std::clamp(pixel.y() + 0.5F, -1e6F, 1e6F) );
			const bool inside = pixel.x() > -0.5F && pixel.y() > -0.5F && u < m_rays.width_px && v < m_rays.height_px;
			if (inside && depth_m < m_sure_depth_m && m_rays.reach(u, v) > depth_m + m_voxel_half.x()) return true;
			if (around(u, v) <= nearest_m) return false;
		}
		return anyRayPasses(voxel, {center, m_voxel_half});
	}

	[[nodiscard]] bool anyRayPasses(const GridKey& voxel, const CubeView& view) const
	{
		PixelRect rect = rectOf(m_rays, view);
		rect = {std::max(rect.u0, 0), std::max(rect.v0, 0), std::min(rect.u1, m_rays.width_px - 1),
		        std::min(rect.v1, m_rays.height_px - 1)};
		if (m_pyramid.farthestIn(rect) <= view.nearest_m()) return false;
		const Eigen::Array3f low = (voxel - m_rays.origin_key).cast<float>() - m_rays.origin.array();
		const float nearest_m = std::max(view.nearest_m(), 0.0F);
		for (int v = rect.v0; v <= rect.v1; ++v)
			for (int u = rect.u0; u <= rect.u1; ++u)
				if (const float reach_m = m_rays.reach(u, v); reach_m > nearest_m)
					if (crosses(low, m_rays.direction(u, v), reach_m)) return true;
		return false;
	}

	/** Whether the ray enters the voxel and leaves it before its end. */
	static bool crosses(const Eigen::Array3f& low, const Eigen::Vector3f& direction, float reach_m)
	{
		// A ray along a face belongs to the voxel above, as its points do; 0 · ∞ would be undefined.
		const Eigen::Array3f inverse = (direction.array().abs() < kParallel).select(kParallel, direction.array()).inverse();
		const Eigen::Array3f a = low * inverse, b = (low + 1.0F) * inverse;
		const float enters_m = std::max(a.min(b).maxCoeff(), 0.0F), leaves_m = a.max(b).minCoeff();
		return enters_m < leaves_m && leaves_m < reach_m;
	}

	const FrameRays& m_rays;
	const ReachPyramid& m_pyramid;
	Eigen::Vector3f m_voxel_half, m_block_half;
	float m_sure_depth_m;
};
}  // namespace

void markRayPasses(const FrameRays& rays, const ReachPyramid& pyramid, float range_m, BlockStore& store,
                   std::vector<VoxelBlock*>& in_frame)
{
	const PassFinder finder(rays, pyramid);
	// The rays' ends lie between the camera and the corners of its view, moved out to the range.
	Eigen::AlignedBox3f box(rays.origin);
	for (const float left : {rays.left.front(), rays.left.back()})
		for (const float up : {rays.up.front(), rays.up.back()})
			box.extend(rays.origin + range_m * (rays.voxels_from_camera * Eigen::Vector3f(1.0F, left, up)));
	const GridKey first = blockOfVoxel(rays.origin_key + box.min().array().floor().cast<int>()).max(store.first());
	const GridKey last = blockOfVoxel(rays.origin_key + box.max().array().floor().cast<int>()).min(store.first() + store.edge() - 1);
	for (int x = first.x(); x <= last.x(); ++x)
		for (int y = first.y(); y <= last.y(); ++y)
			for (int z = first.z(); z <= last.z(); ++z)
			{
				const GridKey key(x, y, z);
				if (!finder.mayPass(key)) continue;
				VoxelBlock* block = store.find(key);
				const VoxelBits passes = finder.passesOf(key, block == nullptr ? VoxelBits{} : block->hits);
				if (!passes.any()) continue;
				if (block == nullptr) block = &store.fetch(key);
				block->passes = passes;
				if (!std::exchange(block->in_frame, true)) in_frame.push_back(block);
			}
}
}  // namespace explore
