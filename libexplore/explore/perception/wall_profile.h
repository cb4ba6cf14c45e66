// What is seen through each strip of a wall, and the stretches of it that may be openings.
#pragma once

#include <explore/config/fields.h>
#include <explore/perception/sensor_noise.h>
#include <explore/perception/wall_rays.h>

#include <array>
#include <vector>

namespace explore
{
/** What a ray met, seen from the wall that it would hit (remedy 2). */
enum class RayMet
{
	wall,     ///< on it, within tolerance
	beside,   ///< a little in front: a wall across that meets it, a casing
	front,    ///< well in front: something stands there and hides the wall
	shallow,  ///< behind, but not as far as the robot is long
	through,  ///< further behind, or the floor behind
	no_return,
};
inline constexpr std::size_t kRayMetKinds = 6;

struct RayEvidenceConfig
{
	double tolerance_m = 0.02;      ///< of the wall's surface, at zero range
	double tolerance_sigmas = 3.0;  ///< σ_z along the ray, added
	double beside_m = 0.15;         ///< up to this far in front counts as beside
	double bottom_m = 0.15;         ///< the band of heights in which openings are looked for
	double top_m = 1.7;
	double floor_m = 0.06;       ///< what lies lower behind a wall is its floor …
	double floor_per_m = 0.015;  ///< … with this much more per metre of depth
	bool tell_apart = true;      ///< false: what is not on the wall leads through (the paper; for comparison)
};
void describe(FieldVisitor& fields, RayEvidenceConfig& config);

/** Sorts the returns of one image into what they say about one wall. */
class RayJudge
{
public:
	/** `free_depth_m`: how far behind the wall a ray must reach to count as through. */
	RayJudge(const LevelView& view, const UprightWall& wall, double free_depth_m, const RayEvidenceConfig& config,
	         const SensorNoiseConfig& noise);

	[[nodiscard]] const WallRays& rays() const { return m_rays; }
	[[nodiscard]] double tolerance_m() const { return m_tolerance_m; }
	/** From the camera to the wall's plane. */
	[[nodiscard]] double distance_m() const { return m_distance_m; }
	[[nodiscard]] float depth(int u, int v) const { return m_image->at(u, v); }
	[[nodiscard]] RayMet met(int u, int v, const WallCrossing& crossing) const;
	/** What the depth noise may move a point along its ray [m]. */
	[[nodiscard]] float noiseOf(float depth_m) const;
	/** Whether the point at `depth_m` of this ray is floor, not something that stands on it. */
	[[nodiscard]] bool isFloor(int u, int v, float depth_m) const;

private:
	const DepthImage* m_image;
	WallRays m_rays;
	float m_tolerance_m, m_sigmas, m_base_m, m_quadratic, m_beside_m, m_free_depth_m, m_floor_m, m_floor_per_m;
	bool m_tell_apart;
	double m_distance_m;
};

/** Rays through one strip of the wall, counted by what they met. */
struct WallStrip
{
	std::array<int, kRayMetKinds> count{};
	int all = 0;
	[[nodiscard]] int of(RayMet met) const { return count.at(static_cast<std::size_t>(met)); }
};

struct WallProfile
{
	double first_m = 0;     ///< along the wall: the lower end of the first strip
	double strip_m = 0.05;  ///< width of a strip
	std::vector<WallStrip> strips;
	[[nodiscard]] double edge_m(std::size_t strip) const { return first_m + static_cast<double>(strip) * strip_m; }
};

/** Counts thinned rays through the wall's plane, from `margin_m` before its extent to as much behind. */
WallProfile wallProfile(const RayJudge& judge, const LevelView& view, const UprightWall& wall, double margin_m,
                        const RayEvidenceConfig& config);

/** A stretch of a wall that may be an opening; the ends are good to a strip. */
struct Stretch
{
	double from_m, to_m;
};

/** Stretches of at least `min_width_m` and at most `max_width_m`: (a) all that is not wall between wall and wall,
 *  where something of it leads on; (b) what leads through without a break. */
std::vector<Stretch> candidateStretches(const WallProfile& profile, double min_width_m, double max_width_m);
}  // namespace explore
