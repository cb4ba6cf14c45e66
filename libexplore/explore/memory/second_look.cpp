#include <explore/memory/cube_view.h>
#include <explore/memory/second_look.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr float kBehind_m = 0.25F;    // what is seen below must be that far behind
constexpr float kThickness_m = 0.3F;  // of things: what stands closer in front belongs to the same one
constexpr float kShadowSlack_px = 3.0F;
/** The steps of a walk through the map, in voxels: it may miss a corner, not a body. */
constexpr float kStep_voxels = 0.5F;

/** Looks at the voxels of one frame. */
class SecondLook
{
public:
	explicit SecondLook(const LookInput& input)
	    : m_in(input),
	      m_voxel_half(halfExtent(input.rays, 1.0F)),
	      m_block_half(halfExtent(input.rays, kBlockEdge)),
	      m_range_m(static_cast<float>(std::min(input.config.second_look_range_m, input.config.range_m)))
	{
	}

	/** Whether the block holds things that were hit a moment ago, in a part of the image with no returns. */
	[[nodiscard]] bool isWorthALook(const VoxelBlock& block) const
	{
		if (!m_in.stations.isRecent(block.last_station)) return false;
		const CubeView view{m_in.rays.inCamera(block.key * kBlockEdge, Eigen::Vector3f::Constant(0.5F * kBlockEdge)),
		                    m_block_half};
		return view.farthest_m() > 0.0F && view.nearest_m() < m_range_m &&
		       m_in.pyramid.anyDarkIn(rectOf(m_in.rays, view));
	}

	[[nodiscard]] bool misses(const VoxelBlock& block, int place) const
	{
		const std::uint16_t station = block.hit_station[static_cast<std::size_t>(place)];
		if (!(block.log_odds[static_cast<std::size_t>(place)] >= 0.0F) || !m_in.stations.isRecent(station))
			return false;
		if (block.hits.test(place) || block.passes.test(place)) return false;
		const GridKey voxel = block.voxelAt(place);
		const CubeView view{m_in.rays.inCamera(voxel, Eigen::Vector3f::Constant(0.5F)), m_voxel_half};
		if (view.nearest_m() <= 0.0F || view.center.norm() > m_range_m) return false;
		const PixelRect rect = rectOf(m_in.rays, view);
		return isDark(rect, view) && !wasNearer(voxel, station) && isSeenPastBelow(rect, view) &&
		       !mayBeInShadow(rect, view) && !isBehindOthers(view);
	}

private:
	/** Whether the middle of the voxel's view has no return and all the rest none but from behind it. */
	[[nodiscard]] bool isDark(const PixelRect& rect, const CubeView& view) const
	{
		const int middle_u = (rect.u0 + rect.u1) / 2, middle_v = (rect.v0 + rect.v1) / 2;
		if (middle_u < 0 || middle_v < 0 || middle_u >= m_in.rays.width_px || middle_v >= m_in.rays.height_px)
			return false;
		if (m_in.image.at(middle_u, middle_v) > 0.0F) return false;
		const PixelRect seen = m_in.pyramid.inImage(rect);
		for (int v = seen.v0; v <= seen.v1; ++v)
			for (int u = seen.u0; u <= seen.u1; ++u)
				if (const float depth_m = m_in.image.at(u, v); depth_m > 0.0F && depth_m <= view.farthest_m())
					return false;
		return true;
	}

	/** Whether the voxel's last hit came from nearer than the camera is now. */
	[[nodiscard]] bool wasNearer(const GridKey& voxel, std::uint16_t station) const
	{
		const Eigen::Vector3d center = m_in.store.centerOf(voxel);
		const double then_m = (center - m_in.stations.origin(station)).norm() + Stations::kHop_m;
		const double now_m = (center - m_in.stations.origin(m_in.stations.current())).norm();
		return now_m > then_m;
	}

	[[nodiscard]] bool isSeenPastBelow(const PixelRect& rect, const CubeView& view) const
	{
		const int u = (rect.u0 + rect.u1) / 2;
		for (int v = (rect.v0 + rect.v1) / 2; v < m_in.rays.height_px; ++v)
			if (const float depth_m = m_in.image.at(u, v); depth_m > 0.0F)
				return depth_m > view.farthest_m() + kBehind_m;
		return false;
	}

	/** A thing keeps the pattern from as many pixels beside it as its disparity differs from that of what is behind. */
	[[nodiscard]] bool mayBeInShadow(const PixelRect& rect, const CubeView& view) const
	{
		const float disparity_m_px =
		    static_cast<float>(m_in.config.shadow_baseline_m) * std::abs(m_in.rays.px_per_tangent[0]);
		const int v = (rect.v0 + rect.v1) / 2;
		for (int u = 0; u < m_in.rays.width_px; ++u)
		{
			const float depth_m = m_in.image.at(u, v);
			if (depth_m <= 0.0F || depth_m >= view.nearest_m()) continue;
			const auto apart_px = static_cast<float>(std::max(rect.u0 - u, u - rect.u1));
			if (apart_px <= disparity_m_px * (1.0F / depth_m - 1.0F / view.farthest_m()) + kShadowSlack_px) return true;
		}
		return false;
	}

	[[nodiscard]] bool isBehindOthers(const CubeView& view) const
	{
		const float distance_m = view.center.norm();
		const Eigen::Vector3f way = m_in.rays.voxels_from_camera * view.center;  // in voxels
		const auto steps = static_cast<int>(way.norm() / kStep_voxels);
		for (int i = 1; i < steps; ++i)
		{
			const float share = static_cast<float>(i) / static_cast<float>(steps);
			if ((1.0F - share) * distance_m < kThickness_m) return false;
			const Eigen::Vector3f at = m_in.rays.origin + share * way;
			if (m_in.store.logOdds(m_in.rays.origin_key + at.array().floor().cast<int>()) >= 0.0F) return true;
		}
		return false;
	}

	const LookInput& m_in;
	Eigen::Vector3f m_voxel_half, m_block_half;
	float m_range_m;
};
}  // namespace

std::vector<MissedVoxel> missedAtSecondLook(const LookInput& input)
{
	std::vector<MissedVoxel> missed;
	const SecondLook look(input);
	for (VoxelBlock* block : input.store.blocks())
	{
		if (!look.isWorthALook(*block)) continue;
		for (int place = 0; place < kBlockVoxels; ++place)
			if (look.misses(*block, place)) missed.push_back({block, place});
	}
	return missed;
}
}  // namespace explore
