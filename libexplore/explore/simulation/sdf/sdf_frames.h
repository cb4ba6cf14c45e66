// Poses that refer to other frames, as libsdformat resolves them.
#pragma once

#include <explore/simulation/sdf/warnings.h>
#include <explore/simulation/sdf/xml.h>

namespace explore::simulation
{
/** Rewrites the poses of `world` (includes expanded) that use frames (`relative_to`, `<frame>`, `placement_frame`) so
 * that each is relative to the element around it. What libsdformat cannot resolve is taken as written, with a warning.
 */
void resolveFrames(XmlNode& world, Warnings& warnings);
}  // namespace explore::simulation
