// The camera's rays in the plan view, each with the distance up to which nothing stands in its way.
#pragma once

#include <explore/navigation/level_frame.h>
#include <explore/perception/sight_lines.h>

#include <vector>

namespace explore
{
/** A ray as the plan view shows it: it runs from the camera along `bearing_rad` and rises by `slope` a metre. */
struct LevelRay
{
	float bearing_rad, slope;
	float hit_m;    ///< horizontal distance of what it met; 0 = no return
	float clear_m;  ///< horizontal distance up to which it is held to be free
};

/** The sight lines in the level frame. */
struct LevelSight
{
	const SightLines* lines = nullptr;  ///< must outlive this
	LevelFrame level;
	Eigen::Vector3d camera = Eigen::Vector3d::Zero();  ///< in the level frame
	std::vector<LevelRay> rays;

	/** Whether the camera looks in a direction (azimuth and elevation about the level frame). */
	[[nodiscard]] bool sees(double azimuth_rad, double elevation_rad) const;
};

/** `lines` must outlive the result.
 *
 *  A ray that met something is clear up to there. One without return met something black, shiny, too near, or nothing
 *  within the sensor's range; it is held to be clear as far as what surrounds it in the image: the further of its
 *  neighbours to the left and right, and the further of those above and below, whichever of both is less. Where the
 *  floor comes next below, what stands on it is no further than that. A neighbour on a surface that falls back steeply,
 *  as floor and walls of a corridor do at its far end, sets no bound: such a surface stops answering. Where nothing was
 *  measured down to the image's lower edge, something may be too near to be measured, and the ray is clear nowhere,
 *  unless surfaces that fall back end above and beside it.
 *  Specks of a few rays, and the image's rim, are as clear as what is next to them. */
LevelSight sightInLevel(const SightLines& lines, const LevelFrame& level);
}  // namespace explore
