// One pass over the rays in and beside an opening: counts of what they met.
#pragma once

#include <explore/perception/doorway_plan.h>
#include <explore/perception/opening_evidence.h>

#include <vector>

namespace explore
{
constexpr double kRayTop_m = 2.8;  ///< no lintel is looked for higher
constexpr double kRayHeightBin_m = 0.05, kRayStrip_m = 0.05;
constexpr double kBesideOpening_m = 0.3;  ///< of wall looked at beside each jamb

/** part / whole; 0 of nothing. */
[[nodiscard]] inline double shareOf(int part, int whole)
{
	return whole == 0 ? 0.0 : static_cast<double>(part) / whole;
}

/** Rays by what they met. */
struct RayCounts
{
	int all = 0, wall = 0, beside = 0, front = 0, stopped = 0, through = 0, nothing = 0;

	[[nodiscard]] int behind() const { return stopped + through; }

	void add(RayMet met)
	{
		++all;
		wall += static_cast<int>(met == RayMet::wall);
		beside += static_cast<int>(met == RayMet::beside);
		front += static_cast<int>(met == RayMet::front);
		stopped += static_cast<int>(met == RayMet::shallow);
		through += static_cast<int>(met == RayMet::through);
		nothing += static_cast<int>(met == RayMet::no_return);
	}
};

/** Pixels of near surfaces, and the holes amid them. */
struct SurfaceHoles
{
	int surface = 0, missing = 0;

	[[nodiscard]] double share() const
	{
		return surface + missing < 40 ? 0.0 : static_cast<double>(missing) / (surface + missing);
	}
};

/** Everything that is counted in one pass over the rays. */
struct RayTally
{
	std::vector<RayCounts> heights, strips;
	RayCounts body, left, right;
	std::vector<RayCounts> left_heights, right_heights;  ///< of the wall beside, by height
	int floor = 0, below_floor = 0;                      ///< where the floor right behind should be
	int near_floor = 0, no_floor = 0;                    ///< of near ones, those without a return
	SurfaceHoles holes, wall_holes;
	int wall_rays = 0, wall_nothing = 0;
	int reveals = 0;  ///< end on the face of the far jamb, or on a leaf that stands open there: nothing against a way
	int far_floor = 0, no_far_floor = 0;  ///< as floor, further behind
	std::vector<float> stop_depths_m, reveal_depths_m;
	float lowest_m = 100.0F, highest_m = -100.0F;
};

/** Counts the rays of the pixels that are given to it. */
class OpeningRays
{
public:
	OpeningRays(const RayJudge& judge, const DepthImage& image, const OpeningFrame& frame, const BodyBand& body,
	            double free_depth_m, double front_m, DoorwayPlan& plan);

	void take(int u, int v);
	[[nodiscard]] RayTally& tally() { return m_tally; }

private:
	void beside(int u, int v, const WallCrossing& crossing, RayMet met, double off_m, bool is_left);
	void sight(int u, int v, const WallCrossing& crossing, double from_left_m);
	void inside(int u, int v, const WallCrossing& crossing, RayMet met, double from_left_m);
	[[nodiscard]] bool isReveal(int u, int v, const WallCrossing& crossing, double behind_m) const;
	void countHoles(int u, int v, SurfaceHoles& holes) const;
	[[nodiscard]] float nextReturn(int u, int v, int step) const;
	void floorBeyond(int u, int v, const WallCrossing& crossing);
	void standing(int u, int v, const WallCrossing& crossing);
	[[nodiscard]] bool isFlying(int u, int v, float depth_m) const;

	const RayJudge& m_judge;
	const DepthImage& m_image;
	const OpeningFrame& m_frame;
	BodyBand m_body;
	double m_free_depth_m, m_front_m;
	DoorwayPlan& m_plan;
	RayTally m_tally;
	int m_sights = 0;
};
}  // namespace explore
