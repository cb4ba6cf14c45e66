// The paper's choice among directions: θ* = argmax d(θ) cos(θ − θ_d) over the swept corridors (§3.2).
#pragma once

#include <explore/navigation/avoider.h>
#include <explore/navigation/ways.h>

namespace explore
{
/** θ* among the candidates θ_d + k · resolution (MAV: at elevations desired + m · step within ± max_elevation, cos of
 * the angle in space; level only where no floor was seen). Where it is known what the camera saw, the candidates are
 * the directions in view, up to 90° from θ_d; else those within ± sector.
 *
 *  The paper crops the obstacle set to ± 45° of θ_d. Here every obstacle point takes part: a point beside the robot
 *  that the hull would touch on a candidate's way must count, and the others change nothing, because d(θ) looks at
 *  θ's own corridor only. d(θ) is the length that is to be expected (see unseen_space.h), capped at goal_distance +
 *  radius, so that a way that is free up to the goal is not left.
 *
 *  The greatest score is often that of a direction that just grazes something, where a centimetre decides. Among those
 *  that come within 3 % of it the one wins whose neighbours on both sides are good too: the middle of the way and not
 *  its edge. Of equal ones the nearest to θ_d wins. Of the two sides of θ_d, when both have such a candidate, the one
 *  the robot faces more wins, so that noise does not turn it to and fro; left, when it faces neither. With method =
 *  paper the greatest score wins. */
Avoidance bestDirection(const Ways& ways, const AvoiderInput& input, const RobotConfig& robot,
                        const AvoiderConfig& config);
}  // namespace explore
