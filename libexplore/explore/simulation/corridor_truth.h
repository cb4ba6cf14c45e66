// Which corridor a camera looks along, if any.
#pragma once

#include <explore/core/truth.h>
#include <explore/simulation/truth_view.h>

namespace explore::simulation
{
/** Of the world's labelled corridors 0.8 – 4 m wide the one of which most is in view. Each wall is looked at every 10
 * cm along the label's axis, at the camera's height and 30 cm above and below, 2 cm before its face: a station is seen
 * when one of the three rays arrives at a wall within 10 cm of where the label has it. The walls' common part runs
 * between the first and the last station seen of both; of it both walls must show a third at least, so that a door, a
 * pillar or a person does not cut it. At least 3 widths of it make a `corridor`, 1.3 are needed to say anything. The
 * direction is that of the label's axis, away from the camera. */
TruthCorridor corridorInView(const RayScene& scene, const TruthView& view);
}  // namespace explore::simulation
