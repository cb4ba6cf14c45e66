#include <explore/perception/opening_rays.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kInset_m = 0.03;      // rays this near to a jamb may be either's
constexpr float kFloorLook_m = 1.6F;   // behind the wall
constexpr float kNearFloor_m = 3.2F;   // nearer floors return for sure
constexpr float kFloorSeen_m = 4.5F;   // further away a floor is too flat to return anything for sure
constexpr float kSteady_m = 5.0F;      // further away returns come and go by themselves
constexpr float kSameSurface = 0.04F;  // of the depth, from one side of a hole to the other
constexpr int kHoleReach_px = 3;
constexpr int kSightEvery = 4;  // of the rays, which cross the same cells in every row
constexpr double kReveal_m = 0.04;
constexpr double kLeansIn = 0.36, kLeansOut = 0.7;  // tangents: a leaf opened by 70° to 125°
constexpr float kDrop_m = 0.05F, kDropPer_m = 0.012F;
constexpr double kAttached_m = 0.03;  // nearer to a jamb it is the jamb
}  // namespace

OpeningRays::OpeningRays(const RayJudge& judge, const DepthImage& image, const OpeningFrame& frame,
                         const BodyBand& body, double free_depth_m, double front_m, DoorwayPlan& plan)
    : m_judge(judge),
      m_image(image),
      m_frame(frame),
      m_body(body),
      m_free_depth_m(free_depth_m),
      m_front_m(front_m),
      m_plan(plan)
{
	const auto bins = static_cast<std::size_t>(std::ceil(kRayTop_m / kRayHeightBin_m)) + 1;
	m_tally.heights.resize(bins);
	m_tally.left_heights.resize(bins);
	m_tally.right_heights.resize(bins);
	m_tally.strips.resize(static_cast<std::size_t>(std::ceil(frame.width_m() / kRayStrip_m)));
}

void OpeningRays::take(int u, int v)
{
	const WallCrossing crossing = m_judge.rays().at(u, v);
	if (!(crossing.depth_m > 0.0F) || crossing.height_m < 0.0F || crossing.height_m >= kRayTop_m) return;
	const RayMet met = m_judge.met(u, v, crossing);
	const double from_left_m = crossing.along_m - m_frame.left.along_m;
	const double to_right_m = m_frame.right.along_m - crossing.along_m;
	if (from_left_m < 0.0 || to_right_m < 0.0)
		beside(u, v, crossing, met, std::max(-from_left_m, -to_right_m), from_left_m < 0.0);
	else if (from_left_m > kInset_m && to_right_m > kInset_m)
		inside(u, v, crossing, met, from_left_m);
	standing(u, v, crossing);
}

void OpeningRays::beside(int u, int v, const WallCrossing& crossing, RayMet met, double off_m, bool is_left)
{
	if (off_m < kInset_m / 2 || off_m > kBesideOpening_m || crossing.height_m < m_body.bottom_m) return;
	(is_left ? m_tally.left : m_tally.right).add(met);
	auto& heights = is_left ? m_tally.left_heights : m_tally.right_heights;
	heights[static_cast<std::size_t>(crossing.height_m / kRayHeightBin_m)].add(met);
	++m_tally.wall_rays;
	m_tally.wall_nothing += static_cast<int>(met == RayMet::no_return);
	countHoles(u, v, m_tally.wall_holes);
}

void OpeningRays::inside(int u, int v, const WallCrossing& crossing, RayMet met, double from_left_m)
{
	const float behind_m = -m_judge.rays().inFront_m(crossing, m_judge.depth(u, v));
	const bool reveal = (met == RayMet::shallow || met == RayMet::wall) && isReveal(u, v, crossing, behind_m);
	// The first centimetres of the far jamb's face count as wall, but are neither sill nor lintel.
	if (!reveal || met != RayMet::wall)
		m_tally.heights[static_cast<std::size_t>(crossing.height_m / kRayHeightBin_m)].add(met);
	m_tally.lowest_m = std::min(m_tally.lowest_m, crossing.height_m);
	m_tally.highest_m = std::max(m_tally.highest_m, crossing.height_m);
	floorBeyond(u, v, crossing);
	if (crossing.height_m < m_body.bottom_m || crossing.height_m > m_body.top_m) return;
	countHoles(u, v, m_tally.holes);
	sight(u, v, crossing, from_left_m);
	RayCounts& strip =
	    m_tally.strips[std::min(m_tally.strips.size() - 1, static_cast<std::size_t>(from_left_m / kRayStrip_m))];
	if (reveal)
	{
		++m_tally.reveals;
		m_tally.reveal_depths_m.push_back(behind_m);
		return;
	}
	// The floor right behind says nothing about how far the way goes on.
	if (met == RayMet::through && behind_m < m_free_depth_m) return;
	m_tally.body.add(met);
	strip.add(met);
	if (met == RayMet::shallow) m_tally.stop_depths_m.push_back(behind_m);
}

/** What lies between the wall's plane and the return is free. */
void OpeningRays::sight(int u, int v, const WallCrossing& crossing, double from_left_m)
{
	const float depth_m = m_judge.depth(u, v);
	if (!(depth_m > crossing.depth_m) || m_sights++ % kSightEvery != 0) return;
	m_plan.addSight(static_cast<float>(from_left_m),
	                m_judge.rays().alongAt(u, v, depth_m) - static_cast<float>(m_frame.left.along_m),
	                -m_judge.rays().inFront_m(crossing, depth_m));
}

/** The ray moves away from the camera's foot along the wall, and may end on the face of the jamb there, or on a
 * leaf that stands open at it: across the wall, leaning in or out by some degrees. */
bool OpeningRays::isReveal(int u, int v, const WallCrossing& crossing, double behind_m) const
{
	const float depth_m = m_judge.depth(u, v);
	const bool right = crossing.along_m > 0.0F;
	const double along_m = m_judge.rays().alongAt(u, v, depth_m);
	const double inward_m = right ? m_frame.right.along_m - along_m : along_m - m_frame.left.along_m;
	const double tolerance_m = kReveal_m + m_judge.noiseOf(depth_m);
	const double deep_m = std::max(0.0, behind_m);
	return inward_m < tolerance_m + kLeansIn * deep_m && inward_m > -tolerance_m - kLeansOut * deep_m;
}

/** Glass loses pixels here and there amid the surface behind it; what is out of range is missing as a whole, and
 *  flickers only far away. */
void OpeningRays::countHoles(int u, int v, SurfaceHoles& holes) const
{
	const float depth_m = m_image.at(u, v);
	if (depth_m > 0.0F)
	{
		holes.surface += static_cast<int>(depth_m < kSteady_m);
		return;
	}
	const float left_m = nextReturn(u, v, -1), right_m = nextReturn(u, v, 1);
	const bool amid = left_m > 0.0F && right_m > 0.0F && std::max(left_m, right_m) < kSteady_m &&
	                  std::abs(left_m - right_m) < kSameSurface * left_m;
	holes.missing += static_cast<int>(amid);
}

/** The first return within a few columns; 0 = none. */
float OpeningRays::nextReturn(int u, int v, int step) const
{
	for (int i = 1; i <= kHoleReach_px; ++i)
	{
		const int other_u = u + i * step;
		if (other_u < 0 || other_u >= m_image.intrinsics.width_px) return 0.0F;
		const float depth_m = m_image.at(other_u, v);
		if (depth_m > 0.0F) return depth_m;
	}
	return 0.0F;
}

/** Rays that would meet the floor right behind the wall (remedy 15). */
void OpeningRays::floorBeyond(int u, int v, const WallCrossing& crossing)
{
	const WallRays& rays = m_judge.rays();
	const float drop_per_m = (rays.heightAt(u, v, 1.0F) - rays.heightAt(u, v, 0.0F));
	if (drop_per_m > -0.02F) return;
	const float floor_depth_m = -rays.heightAt(u, v, 0.0F) / drop_per_m;
	const float behind_m = -rays.inFront_m(crossing, floor_depth_m);
	if (behind_m < 0.05F || floor_depth_m > kFloorSeen_m) return;
	const float depth_m = m_judge.depth(u, v);
	if (behind_m > kFloorLook_m)
	{
		if (!(depth_m > 0.0F)) return;
		const float height_m = rays.heightAt(u, v, depth_m);
		if (height_m < -(kDrop_m + kDropPer_m * depth_m))
			++m_tally.no_far_floor;
		else if (m_judge.isFloor(u, v, depth_m))
			++m_tally.far_floor;
		return;
	}
	const bool is_near = floor_depth_m < kNearFloor_m;
	m_tally.near_floor += static_cast<int>(is_near);
	if (!(depth_m > 0.0F))
	{
		m_tally.no_floor += static_cast<int>(is_near);
		return;
	}
	const float height_m = rays.heightAt(u, v, depth_m);
	if (height_m < -(kDrop_m + kDropPer_m * depth_m))
		++m_tally.below_floor;
	else if (m_judge.isFloor(u, v, depth_m))
		++m_tally.floor;
}

void OpeningRays::standing(int u, int v, const WallCrossing& crossing)
{
	const float depth_m = m_judge.depth(u, v);
	if (!(depth_m > 0.0F)) return;
	const WallRays& rays = m_judge.rays();
	const float behind_m = -rays.inFront_m(crossing, depth_m);
	if (behind_m < -m_front_m || behind_m > m_free_depth_m) return;
	const float height_m = rays.heightAt(u, v, depth_m);
	if (height_m > m_body.top_m || height_m < m_body.bottom_m || m_judge.isFloor(u, v, depth_m)) return;
	const double along_m = rays.alongAt(u, v, depth_m);
	// Noise moves points along their rays, and so along the wall.
	const double attached_m = kAttached_m + m_judge.noiseOf(depth_m) * std::abs(along_m) / depth_m;
	if (along_m < m_frame.left.along_m + attached_m || along_m > m_frame.right.along_m - attached_m) return;
	if (isFlying(u, v, depth_m)) return;
	m_plan.add(static_cast<float>(along_m - m_frame.left.along_m), behind_m, height_m);
}

/** At a depth edge a pixel may return a depth between both surfaces, where nothing is. */
bool OpeningRays::isFlying(int u, int v, float depth_m) const
{
	const auto near = [&](int other_u)
	{
		if (other_u < 0 || other_u >= m_image.intrinsics.width_px) return false;
		const float other_m = m_image.at(other_u, v);
		return other_m > 0.0F && std::abs(other_m - depth_m) < 0.03F * depth_m;
	};
	return !near(u - 1) || !near(u + 1);
}
}  // namespace explore
