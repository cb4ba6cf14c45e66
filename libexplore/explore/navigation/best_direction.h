// The paper's choice among directions: θ* = argmax d(θ) cos(θ − θ_d) over the swept corridors (§3.2).
#pragma once

#include <explore/navigation/avoider.h>
#include <explore/navigation/open_path.h>

namespace explore
{
/** θ* among the candidates θ_d + k · resolution within ± sector (MAV: at elevations desired + m · step within
 *  ± max_elevation, cos of the angle in space; level only where no floor was seen).
 *
 *  The paper crops the obstacle set to ± 45° of θ_d. Here every obstacle point takes part: a point beside the robot
 *  that the hull would touch on a candidate's way must count, and the others change nothing, because d(θ) looks at
 *  θ's own corridor only.
 *
 *  d is capped at goal_distance + radius, so that a way that is free up to the goal is not left. Of equal candidates
 * the one nearest to θ_d wins. Of the two sides of θ_d, when they differ by less than 5 %, the one the robot faces more
 *  wins, so that noise does not turn it to and fro; left, when it faces neither. */
Avoidance bestDirection(const OpenPath& open_path, const AvoiderInput& input, const RobotConfig& robot,
                        const AvoiderConfig& config);
}  // namespace explore
