#include <explore/memory/cube_view.h>
#include <explore/memory/octet_look.h>
#include <explore/memory/ray_passes.h>
#include <explore/memory/voxel_crossing.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace explore
{
namespace
{
constexpr int kOctantEdge = kBlockEdge / 2;

/** The bounds keep the conversion defined. */
int nearestPixel(float pixel)
{
	return static_cast<int>(std::clamp(pixel, -kFarOutside_px, kFarOutside_px) + (kFarOutside_px + 0.5F)) -
	       static_cast<int>(kFarOutside_px);
}

/** Decides about the voxels of one frame. */
class PassFinder
{
public:
	PassFinder(const FrameRays& rays, const ReachPyramid& pyramid)
	    : m_rays(rays),
	      m_pyramid(pyramid),
	      m_octet(octetLook(rays)),
	      m_octant_half(halfExtent(rays, kOctantEdge)),
	      m_block_half(halfExtent(rays, kBlockEdge)),
	      m_octet_middle(rays.camera_from_voxels * Eigen::Vector3f::Constant(0.5F))
	{
		for (int octet = 0; octet < kBlockVoxels / kOctet; ++octet)
		{
			const auto [x, y, z] = coordinatesOfPlace(octet * kOctet);
			m_octet_start[static_cast<std::size_t>(octet)] = rays.camera_from_voxels * Eigen::Vector3f(x, y, z);
		}
	}

	/** Whether rays may pass through the cube. */
	[[nodiscard]] bool mayPass(const CubeView& cube) const
	{
		return cube.farthest_m() > 0.0F && m_pyramid.farthestIn(rectOf(m_rays, cube)) > cube.nearest_m();
	}
	[[nodiscard]] CubeView viewOf(const GridKey& block) const
	{
		return {m_rays.inCamera(block * kBlockEdge, Eigen::Vector3f::Constant(0.5F * kBlockEdge)), m_block_half};
	}

	/** The voxels of the block that rays pass through, but for those to `skip`. */
	[[nodiscard]] VoxelBits passesOf(const GridKey& block, const VoxelBits& skip) const
	{
		VoxelBits passes;
		for (int octant = 0; octant < 8; ++octant)
		{
			if (skip.words[static_cast<std::size_t>(octant)] == ~std::uint64_t{0}) continue;
			const auto [x, y, z] = coordinatesOfPlace(octant * 64);
			const GridKey first = block * kBlockEdge + GridKey(x, y, z);
			const CubeView view{m_rays.inCamera(first, Eigen::Vector3f::Constant(0.5F * kOctantEdge)), m_octant_half};
			if (mayPass(view)) findInOctant(octant, block, view, skip, passes);
		}
		return passes;
	}

private:
	void findInOctant(int octant, const GridKey& block, const CubeView& view, const VoxelBits& skip,
	                  VoxelBits& passes) const
	{
		const ReachPyramid::Around around = m_pyramid.around(widest_px(view, m_octet.half));
		const ReachPyramid::Around around_octet = m_pyramid.around(widest_px(view, 2.0F * m_octet.half));
		const Eigen::Vector3f first_center = m_rays.inCamera(block * kBlockEdge, Eigen::Vector3f::Constant(0.5F));
		for (int octet = 8 * octant; octet < 8 * (octant + 1); ++octet)
		{
			const unsigned wanted = 0xFFU & ~static_cast<unsigned>(skip.octet(octet));
			if (wanted == 0U) continue;
			const Eigen::Vector3f at = first_center + m_octet_start[static_cast<std::size_t>(octet)];
			if (isHidden(at + m_octet_middle, around_octet)) continue;
			const auto [x, y, z] = coordinatesOfPlace(octet * kOctet);
			passes.setOctet(octet, passesOfOctet(block * kBlockEdge + GridKey(x, y, z), at, wanted, around));
		}
	}

	/** Whether everything around ends in front of an octet with its middle there. */
	[[nodiscard]] bool isHidden(const Eigen::Vector3f& middle, const ReachPyramid::Around& around) const
	{
		const float nearest_m = middle.x() - 2.0F * m_octet.half.x();
		if (nearest_m <= 0.0F) return false;
		const Eigen::Array2f pixel = m_rays.axis_px + m_rays.px_per_tangent * middle.tail<2>().array() / middle.x();
		return around(nearestPixel(pixel.x()), nearestPixel(pixel.y())) <= nearest_m;
	}

	/** Of the voxels in `wanted`, those that are passed; `at` is the centre of the first. */
	[[nodiscard]] std::uint8_t passesOfOctet(const GridKey& first, const Eigen::Vector3f& at, unsigned wanted,
	                                         const ReachPyramid::Around& around) const
	{
		const OctetSight sight = lookAtOctet(m_octet, at, around);
		unsigned passed = sight.passed & wanted;
		for (unsigned open = wanted & ~sight.passed & ~sight.hidden; open != 0U; open &= open - 1U)
		{
			const int place = std::countr_zero(open);
			const auto i = static_cast<std::size_t>(place);
			const auto [x, y, z] = coordinatesOfPlace(place);
			const PixelRect rect{sight.u0[i], sight.v0[i], sight.u1[i], sight.v1[i]};
			if (anyRayCrosses(m_rays, first + GridKey(x, y, z), rect, sight.nearest_m[i])) passed |= 1U << i;
		}
		return static_cast<std::uint8_t>(passed);
	}

	/** How far from its centre's pixel a part of a cube, in a box with that half extent, may be seen. */
	[[nodiscard]] float widest_px(const CubeView& cube, const Eigen::Vector3f& part_half) const
	{
		const float nearest_m = cube.nearest_m();
		if (nearest_m <= 0.0F) return std::numeric_limits<float>::infinity();
		const float tangent = (cube.center.tail<2>().cwiseAbs() + cube.half.tail<2>()).maxCoeff() / nearest_m;
		const float extent_m = part_half.tail<2>().maxCoeff() + tangent * part_half.x();
		return m_rays.px_per_tangent.abs().maxCoeff() * extent_m / nearest_m +
		       0.6F;  // and the rounding of its own pixel
	}

	const FrameRays& m_rays;
	const ReachPyramid& m_pyramid;
	OctetLook m_octet;
	Eigen::Vector3f m_octant_half, m_block_half;
	// In camera axes [m]:
	std::array<Eigen::Vector3f, kBlockVoxels / kOctet> m_octet_start{};  ///< of octets from a block's first one
	Eigen::Vector3f m_octet_middle;  ///< of an octet's middle from its first voxel's
};

/** The blocks that rays may reach. */
struct BlockRange
{
	GridKey first, last;
};

BlockRange blocksInView(const FrameRays& rays, float range_m)
{
	// The rays' ends lie between the camera and the corners of its view, moved out to the range.
	Eigen::AlignedBox3f box(rays.origin);
	for (const float left : {rays.left[0], rays.left[static_cast<std::size_t>(rays.width_px) - 1]})
		for (const float up : {rays.up.front(), rays.up.back()})
			box.extend(rays.origin + range_m * (rays.voxels_from_camera * Eigen::Vector3f(1.0F, left, up)));
	const auto block = [&](const Eigen::Vector3f& corner)
	{ return blockOfVoxel(rays.origin_key + corner.array().floor().cast<int>()); };
	return {block(box.min()), block(box.max())};
}
}  // namespace

void markRayPasses(const FrameRays& rays, const ReachPyramid& pyramid, float range_m, BlockStore& store,
                   std::vector<VoxelBlock*>& in_frame)
{
	const PassFinder finder(rays, pyramid);
	BlockRange range = blocksInView(rays, range_m);
	range.first = range.first.max(store.first());
	range.last = range.last.min(store.first() + store.edge() - 1);
	for (int x = range.first.x(); x <= range.last.x(); ++x)
		for (int y = range.first.y(); y <= range.last.y(); ++y)
			for (int z = range.first.z(); z <= range.last.z(); ++z)
			{
				const GridKey key(x, y, z);
				VoxelBlock* block = store.find(key);
				const VoxelBits skip = block == nullptr ? VoxelBits{} : block->hits | block->settled;
				if (skip.all() || !finder.mayPass(finder.viewOf(key))) continue;
				const VoxelBits passes = finder.passesOf(key, skip);
				if (!passes.any()) continue;
				if (block == nullptr) block = &store.fetch(key);
				block->passes = passes;
				if (!std::exchange(block->in_frame, true)) in_frame.push_back(block);
			}
}
}  // namespace explore
