// MRPT's holonomic methods (CHolonomicND, CHolonomicVFF, CHolonomicFullEval) on the obstacle set of open_path.
#pragma once

#include <explore/navigation/avoider.h>
#include <explore/navigation/ways.h>

namespace explore
{
/** The direction that the MRPT method of config.method chooses, in the horizontal plane.
 *
 *  The method sees a full turn of open paths d(θ), 2° apart or more, in units of max_range_m, turned so that θ_d is
 * straight ahead, and a target at θ_d, at goal_distance (at the range's end without one). Directions outside ± sector
 * are closed to CHolonomicND and CHolonomicFullEval; CHolonomicVFF, which sums forces, sees them as they are. What the
 * method answers is believed only within the sector and where d(θ) > 0: otherwise there is no heading. */
Avoidance mrptDirection(const Ways& ways, const AvoiderInput& input, const AvoiderConfig& config);
}  // namespace explore
