#include <explore/perception/wall_profile.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr int kFewRays = 3;  // fewer through a strip say nothing

/** What a strip of the wall is, by the majority of its rays. */
enum class StripIs
{
	unseen,
	wall,     ///< or what stands flush with it
	hidden,   ///< behind something in front
	blocked,  ///< ends behind, but not far
	open,
	nothing  ///< no returns
};

StripIs kindOf(const WallStrip& strip)
{
	if (strip.all < kFewRays) return StripIs::unseen;
	const int wall = strip.of(RayMet::wall), hidden = strip.of(RayMet::front) + strip.of(RayMet::beside);
	const int blocked = strip.of(RayMet::shallow), open = strip.of(RayMet::through);
	const int nothing = strip.of(RayMet::no_return);
	// No return is a lack of evidence: it decides only where there is little else.
	const int rest = strip.all - nothing;
	if (4 * rest < strip.all) return StripIs::nothing;
	const int most = std::max({wall, hidden, blocked, open});
	if (most == wall) return StripIs::wall;
	if (most == open) return StripIs::open;
	return most == hidden ? StripIs::hidden : StripIs::blocked;
}

bool leadsOn(StripIs strip)
{
	return strip == StripIs::open || strip == StripIs::blocked || strip == StripIs::nothing;
}

void addUnlessKnown(std::vector<Stretch>& stretches, const Stretch& stretch, double strip_m)
{
	const bool known = std::ranges::any_of(stretches,
	                                       [&](const Stretch& other)
	                                       {
		                                       return std::abs(other.from_m - stretch.from_m) < 1.5 * strip_m &&
		                                              std::abs(other.to_m - stretch.to_m) < 1.5 * strip_m;
	                                       });
	if (!known) stretches.push_back(stretch);
}

/** Whether the wall itself begins at one end of a run of strips, or a strip further. */
bool isWallBeside(const std::vector<StripIs>& kinds, std::size_t first, std::size_t end)
{
	const auto is_wall = [&](std::size_t strip) { return strip < kinds.size() && kinds[strip] == StripIs::wall; };
	return is_wall(first - 1) || is_wall(first - 2) || is_wall(end) || is_wall(end + 1);
}

/** Calls take(first, end) for each maximal run of strips that `belongs`, of which up to `gap` in a row may not. */
template <class Belongs, class Take>
void forEachRun(const std::vector<StripIs>& kinds, std::size_t gap, const Belongs& belongs, const Take& take)
{
	std::size_t first = 0, end = 0;
	bool open = false;
	for (std::size_t i = 0; i < kinds.size(); ++i)
	{
		if (belongs(kinds[i]))
		{
			if (!open) first = i;
			open = true;
			end = i + 1;
		}
		else if (open && (i + 1 - end > gap || kinds[i] == StripIs::wall))
		{
			take(first, end);
			open = false;
		}
	}
	if (open) take(first, end);
}
}  // namespace

void describe(FieldVisitor& fields, RayEvidenceConfig& config)
{
	fields.real("surface_tolerance", config.tolerance_m, {0.001, 0.2}, "m",
	            "A ray ends on a wall within this much of its plane, at zero range.");
	fields.real("surface_sigmas", config.tolerance_sigmas, {0.5, 10.0}, "",
	            "Added to surface_tolerance: this many standard deviations of the depth.");
	fields.real("beside", config.beside_m, {0.01, 1.0}, "m",
	            "What lies in front of a wall by less may be a casing or a wall across that meets it.");
	fields.real("band_bottom", config.bottom_m, {0.02, 1.0}, "m",
	            "Openings are looked for from this height above the floor ...");
	fields.real("band_top", config.top_m, {0.5, 4.0}, "m", "... to this one, where a lintel may begin.");
	fields.real("floor_height", config.floor_m, {0.01, 0.5}, "m",
	            "What lies lower behind a wall is the floor there, ...");
	fields.real("floor_slope", config.floor_per_m, {0.0, 0.2}, "",
	            "... with this much more per metre of depth, for floors that are not quite level.");
}

RayJudge::RayJudge(const LevelView& view, const UprightWall& wall, double free_depth_m, const RayEvidenceConfig& config,
                   const SensorNoiseConfig& noise)
    : m_image(view.image),
      m_rays(view.pose, view.image->intrinsics, wall),
      m_tolerance_m(static_cast<float>(config.tolerance_m)),
      m_sigmas(static_cast<float>(config.tolerance_sigmas * noise.scale)),
      m_base_m(static_cast<float>(noise.base_m)),
      m_quadratic(static_cast<float>(noise.quadratic_per_m)),
      m_beside_m(static_cast<float>(config.beside_m)),
      m_free_depth_m(static_cast<float>(free_depth_m)),
      m_floor_m(static_cast<float>(config.floor_m)),
      m_floor_per_m(static_cast<float>(config.floor_per_m)),
      m_tell_apart(config.tell_apart),
      m_distance_m(wall.offset_m)
{
}

float RayJudge::noiseOf(float depth_m) const
{
	// depthSigma() in sensor_noise.h, inlined because it is asked for every ray.
	const float beyond_m = depth_m - 0.4F;
	return m_sigmas * (m_base_m + m_quadratic * beyond_m * beyond_m);
}

bool RayJudge::isFloor(int u, int v, float depth_m) const
{
	return m_rays.heightAt(u, v, depth_m) < m_floor_m + m_floor_per_m * depth_m;
}

RayMet RayJudge::met(int u, int v, const WallCrossing& crossing) const
{
	const float depth_m = m_image->at(u, v);
	if (!(depth_m > 0.0F)) return m_tell_apart ? RayMet::no_return : RayMet::through;
	const float tolerance_m = m_tolerance_m + noiseOf(crossing.depth_m) * crossing.slope;
	const float in_front_m = m_rays.inFront_m(crossing, depth_m);
	if (!m_tell_apart && std::abs(in_front_m) > tolerance_m) return RayMet::through;
	if (in_front_m > tolerance_m) return in_front_m < tolerance_m + m_beside_m ? RayMet::beside : RayMet::front;
	if (in_front_m >= -tolerance_m) return RayMet::wall;
	if (in_front_m < -m_free_depth_m || isFloor(u, v, depth_m)) return RayMet::through;
	return RayMet::shallow;
}

namespace
{
constexpr int kFurthestReach = 10;  // strips that one ray may stand for

void addTo(std::vector<WallStrip>& strips, int first, int last, RayMet met)
{
	if (last - first > kFurthestReach) return;
	for (int i = first; i <= last; ++i)
	{
		WallStrip& strip = strips[static_cast<std::size_t>(i)];
		++strip.count.at(static_cast<std::size_t>(met));
		++strip.all;
	}
}
}  // namespace

WallProfile wallProfile(const RayJudge& judge, const LevelView& view, const UprightWall& wall, double margin_m,
                        const RayEvidenceConfig& config)
{
	WallProfile profile;
	profile.first_m = wall.from_m - margin_m;
	const double length_m = wall.to_m - wall.from_m + 2.0 * margin_m;
	profile.strips.resize(static_cast<std::size_t>(std::max(1.0, std::ceil(length_m / profile.strip_m))));
	const PixelBox box =
	    judge.rays().boxOf({profile.first_m, profile.first_m + length_m, config.bottom_m, config.top_m});
	// Seen from the side neighbouring rays are strips apart: each stands for all from the ray before it on.
	const int step_u = std::max(1, view.samples.stride / 2), step_v = 2 * view.samples.stride;
	const auto per_m = static_cast<float>(1.0 / profile.strip_m), first_m = static_cast<float>(profile.first_m);
	const auto last = static_cast<int>(profile.strips.size()) - 1;
	const auto bottom_m = static_cast<float>(config.bottom_m), top_m = static_cast<float>(config.top_m);
	for (int v = box.first_v; v <= box.last_v; v += step_v)
	{
		int before = -1;
		for (int u = box.first_u; u <= box.last_u; u += step_u)
		{
			const WallCrossing crossing = judge.rays().at(u, v);
			const float place = (crossing.along_m - first_m) * per_m;
			const bool counts = crossing.depth_m > 0.0F && crossing.height_m >= bottom_m &&
			                    crossing.height_m <= top_m && place >= 0.0F && place < static_cast<float>(last + 1);
			if (!counts)
			{
				before = -1;
				continue;
			}
			const int strip = static_cast<int>(place), reach = before < 0 ? strip : before;
			const RayMet met = judge.met(u, v, crossing);
			addTo(profile.strips, std::min(strip, reach + 1), std::max(strip, reach - 1), met);
			before = strip;
		}
	}
	return profile;
}

std::vector<Stretch> candidateStretches(const WallProfile& profile, double min_width_m, double max_width_m)
{
	std::vector<StripIs> kinds(profile.strips.size());
	std::ranges::transform(profile.strips, kinds.begin(), kindOf);
	std::vector<Stretch> stretches;
	const auto offer = [&](std::size_t first, std::size_t end)
	{
		const Stretch stretch{profile.edge_m(first), profile.edge_m(end)};
		const double width_m = stretch.to_m - stretch.from_m;
		const bool beside_wall = isWallBeside(kinds, first, end);
		const bool leads = beside_wall && std::any_of(kinds.begin() + static_cast<std::ptrdiff_t>(first),
		                                              kinds.begin() + static_cast<std::ptrdiff_t>(end), leadsOn);
		if (leads && width_m >= min_width_m && width_m <= max_width_m)
			addUnlessKnown(stretches, stretch, profile.strip_m);
	};
	forEachRun(
	    kinds, 0, [](StripIs kind) { return kind != StripIs::wall && kind != StripIs::unseen; }, offer);
	forEachRun(kinds, 0, leadsOn, offer);
	forEachRun(
	    kinds, 1, [](StripIs kind) { return kind == StripIs::open; }, offer);
	return stretches;
}
}  // namespace explore
