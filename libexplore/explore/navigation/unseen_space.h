// The parts of the plan view that the camera saw nothing of, and what they leave of a way's length.
#pragma once

#include <explore/navigation/level_sight.h>
#include <explore/navigation/open_path.h>

#include <vector>

namespace explore
{
/** The body on its way: its radius, and the heights that it takes up, low … high + slope · distance in the level frame.
 */
struct MovingBody
{
	double radius_m = 0;
	double low_m = 0, high_m = 0;
	double slope = 0;  ///< tangent of the elevation
};

/** What a way is worth where not all of it was observed; one value for each direction of a fan. */
struct WayLengths
{
	std::vector<double> expected_m;  ///< mean of the free length, the unseen being what it is by chance
	std::vector<double> known_m;     ///< up to where there is little to expect in the unseen
	std::vector<bool> seen_start;    ///< whether most of what the hull first passes through was observed
};

/** The plan view in polar cells around the camera. A cell was observed when most of the rays that pass through it at
 * the body's heights are clear up to it. Of the others there are
 *
 *  - blind ones, out of the image: beside the field of view, or (the sensor being above or below the body) between the
 *    robot and the place where the body's heights come into view. Beside the field of view there is an obstacle with
 *    kBlind for each square metre. Straight ahead the robot has seen the stretch before it came to it: it is free,
 *    unless what comes into view behind it is dark.
 *  - dark ones, in the image but without return: with kDark for each square metre. It is so large that the hull does
 *    not get into a dark place as wide as itself, and that a sliver, such as the sensor's own shadow beside everything
 *    that is near, weighs little.
 *
 *  What lies behind an obstacle does not matter: a way ends before. */
class UnseenSpace
{
public:
	/** Ways of up to `range_m`. */
	UnseenSpace(const LevelSight& sight, const MovingBody& body, double range_m);

	/** `open_m` is what the seen obstacles leave free of each direction. */
	[[nodiscard]] WayLengths along(const DirectionFan& fan, const std::vector<double>& open_m) const;

private:
	struct Cell
	{
		float x, y;  ///< middle, level frame
		float distance_m, azimuth_rad;
		float area_m2;
		bool dark;
	};
	struct Polar;
	void addCells(const Polar& polar, const Eigen::Vector3d& camera);

	double m_radius_m, m_range_m;
	std::vector<Cell> m_cells;
};
}  // namespace explore
