// The edge of an opening from the full-resolution image: where "behind the wall" turns into "on the wall".
#pragma once

#include <explore/perception/wall_profile.h>

namespace explore
{
/** What bounds an opening on one side. */
enum class JambKind
{
	wall,         ///< the wall itself ends there
	corner,       ///< another surface meets the wall's plane there, or almost (remedy 5)
	hidden,       ///< something in front hides it
	out_of_view,  ///< beyond the edge of the image
	nothing       ///< no edge that stands
};

enum class JambSide
{
	left,  ///< the end with the smaller along_m
	right
};

struct Jamb
{
	double along_m = 0;
	JambKind kind = JambKind::nothing;
	double support = 0;   ///< share of the rays just beyond the edge that meet what bounds the opening, 0–1
	int rays = 0;         ///< how many there were
	double relief_m = 0;  ///< how far what stands right beside the edge lies before the wall's plane: a casing
	double face = 0;  ///< share of the rays just inside the edge that end a little behind the wall: on the jamb's face
};

struct JambConfig
{
	double search_m = 0.2;        ///< to both sides of the first guess
	double support_m = 0.1;       ///< width of the strip beside the opening that must stand
	bool full_resolution = true;  ///< false: the first guess stays (for comparison)
	bool corners = true;          ///< false: both jambs must stand on the wall's plane (for comparison)
};

/** The vertical line near `guess_m` that best parts the rays that lead behind the wall from those that end on it: the
 *  fewest rays on the wrong side, over all heights of the band. Precise to a fraction of a pixel's width, because the
 *  jamb crosses many rows. */
Jamb fitJamb(const RayJudge& judge, double guess_m, JambSide side, const RayEvidenceConfig& band,
             const JambConfig& config);
}  // namespace explore
