// What the rays of a view met at the two sides of a corridor, strip by strip along it.
#pragma once

#include <explore/perception/corridor_walls.h>

#include <array>
#include <cstddef>
#include <optional>

namespace explore
{
/** Rays that reached the plane of one side, by where along the corridor they did. A ray counts for the stretch between
 *  it and its neighbours in the image, so that far strips, which few rays meet, are not empty. */
struct SideProfile
{
	static constexpr double kStrip_m = 0.1, kFirst_m = -2.0;
	static constexpr std::size_t kStrips = 160;
	std::array<int, kStrips> on{};      ///< ended on the wall
	std::array<int, kStrips> behind{};  ///< went on behind its plane
	std::array<int, kStrips> points{};  ///< of surfaces that run along, by where they were measured

	/** Middle of a strip, along the corridor, 0 = the camera [m]. */
	[[nodiscard]] static double along_m(std::size_t strip)
	{
		return kFirst_m + (static_cast<double>(strip) + 0.5) * kStrip_m;
	}
	[[nodiscard]] bool isWall(std::size_t strip) const
	{
		return on[strip] >= kFewest && kWallShare * behind[strip] <= on[strip];
	}
	[[nodiscard]] bool isOpen(std::size_t strip) const { return behind[strip] >= kFewest && !isWall(strip); }

	/** Length of wall between two places along the corridor [m]. */
	[[nodiscard]] double wallBetween(double from_m, double to_m) const;
	/** The same by measured points. */
	[[nodiscard]] double pointsBetween(double from_m, double to_m) const;

	static constexpr int kFewest = 3;
	static constexpr double kWallShare = 0.25;  ///< a door with a wall above its lintel is an opening, a window wall
};

struct SideProfiles
{
	SideProfile left, right;
};

/** `spacing_rad`: between neighbouring samples. */
SideProfiles sideProfiles(const FacingWalls& pair, const PlanPoints& points, const TurnedPoints& turned,
                          double spacing_rad, const UprightWallConfig& config);

/** Whether the surface at point `i` runs along the corridor rather than across it: its neighbours in the image row are
 *  no further apart across than half of what a wall across would make them. */
[[nodiscard]] bool runsAlong(std::size_t i, const PlanPoints& points, const TurnedPoints& turned, double spacing_rad);

/** Along the corridor, 0 = the camera [m]. */
struct Overlap
{
	double from_m = 0, to_m = 0;
	[[nodiscard]] double length_m() const { return to_m - from_m; }
};

/** From the first to the last strip in which both sides show wall; of that length each side has to be wall for at
 *  least `share`, else it ends sooner. It also ends where both sides open and no walls follow. No value where they have
 *  none in common. */
std::optional<Overlap> overlapOf(const SideProfiles& sides, double share);

/** Angle between neighbouring samples [rad]. */
[[nodiscard]] inline double sampleSpacing(const LevelView& view)
{
	return view.samples.stride / view.image->intrinsics.fx_px;
}
}  // namespace explore
